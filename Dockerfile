# docker build -t braidx . && docker run --rm -it --user "$(id -u):$(id -g)" -v "$PWD:/data" braidx run my_rope.toml
FROM debian:trixie-slim
COPY python/braidx/cli/environment/debian.txt /tmp/packages
RUN apt-get update \
    && DEBIAN_FRONTEND=noninteractive xargs apt-get install --yes --no-install-recommends < /tmp/packages \
    && rm -rf /var/lib/apt/lists/*
COPY . /opt/braidx
# Results belong to the user who starts the container, whatever his number: what he writes beside them is in /var/cache.
ENV XDG_CACHE_HOME=/var/cache HOME=/var/cache/home
RUN /opt/braidx/.ci/warm && mkdir -p "$HOME" && chmod -R a+rwX /var/cache
WORKDIR /data
ENTRYPOINT ["/opt/braidx/braidx"]
CMD ["demo"]
