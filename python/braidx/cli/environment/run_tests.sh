# workers: test files that run side by side. Each takes up to 2 GB; more than a few would not make the set quicker.
workers() {
    local cores
    cores=$(nproc)
    echo $((cores < 4 ? cores : 4))
}

# Builds the engine as it is for any processor, and for those of the level x86-64-v3 (AVX2, FMA), where this is one:
# the tests find them in BRAIDX_BUILDS.
build_for_machines() {
    local arguments=${BRAIDX_CMAKE_ARGS:-} lacking
    build braidx_engine
    export BRAIDX_BUILDS="any=$build"
    lacking=$(for name in avx2 bmi2 f16c fma movbe; do grep -q -m 1 -w "$name" /proc/cpuinfo || echo "$name"; done)
    if [ -n "$lacking" ]; then
        note "this processor is none of the level x86-64-v3 (no" $lacking"): its build is not compared"
        return
    fi
    BRAIDX_CMAKE_ARGS="$arguments -DCMAKE_CXX_FLAGS=-march=x86-64-v3"
    build braidx_engine
    BRAIDX_BUILDS+=" x86-64-v3=$build"
    BRAIDX_CMAKE_ARGS=$arguments
}

# ./braidx test --sanitize [Catch2 arguments]: the C++ tests alone, with every access to memory and every assertion checked.
sanitize() {
    BRAIDX_CMAKE_ARGS="${BRAIDX_CMAKE_ARGS:-} -DBRAIDX_SANITIZE=ON"
    build engine_tests
    "${inside[@]}" "$build/engine_tests" "$@"
}

# ./braidx test: C++ tests through ctest, then Python tests through pytest; fails if either does.

run_tests() {
    local folders=() options=() argument machines='' cpp='not run' py code=0
    if [ "${1:-}" = --sanitize ]; then
        sanitize "${@:2}"
        return
    fi
    for argument in "$@"; do
        case $argument in
        --machines) folders+=("tests/machines") machines=yes ;;
        --verification | --stability | --benchmark | --studies) folders+=("tests/${argument#--}") ;;
        *) options+=("$argument")
            [ -e "$checkout/${argument%%::*}" ] && [ "${argument#-}" = "$argument" ] && folders+=("") ;;
        esac
        [ "$argument" != --verification ] || options+=(--papers)
    done
    cd "$checkout"
    if [ ${#folders[@]} = 0 ]; then
        build all
        if (launch "$python" -c 'import xdist') 2>/dev/null; then options+=(--numprocesses "$(workers)" --dist loadfile); fi
        "${inside[@]}" ctest --test-dir "$build" --output-on-failure --progress && cpp=passed || { code=$? cpp=FAILED; }
        folders=(tests/python tests/verification)
    else
        [ -z "$machines" ] || build_for_machines
        build braidx_engine
    fi
    local existing=() folder
    for folder in "${folders[@]}"; do
        if [ -n "$folder" ] && [ -d "$folder" ]; then existing+=("$folder"); fi
    done
    (launch "$python" -m pytest "${existing[@]}" "${options[@]}") && py=passed || { code=$? py=FAILED; }
    note "ctest $cpp, pytest $py"
    return "$code"
}
