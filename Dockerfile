# docker build -t braidx . && docker run --rm -it -v "$PWD:/data" -w /data braidx run my_rope.toml
FROM debian:trixie-slim
COPY python/braidx/cli/environment/debian.txt /tmp/packages
RUN apt-get update \
    && DEBIAN_FRONTEND=noninteractive xargs apt-get install --yes --no-install-recommends < /tmp/packages \
    && rm -rf /var/lib/apt/lists/*
COPY . /opt/braidx
ENV XDG_CACHE_HOME=/var/cache
RUN /opt/braidx/braidx shell true && chmod -R a+rwX /var/cache/braidx
ENTRYPOINT ["/opt/braidx/braidx"]
CMD ["demo"]
