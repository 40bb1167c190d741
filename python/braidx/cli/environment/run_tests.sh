# workers: test files that run side by side. Each takes up to 2 GB; more than a few would not make the set quicker.
workers() {
    local cores
    cores=$(nproc)
    echo $((cores < 4 ? cores : 4))
}

# ./braidx test: C++ tests through ctest, then Python tests through pytest; fails if either does.

run_tests() {
    local folders=() options=() argument cpp='not run' py code=0
    for argument in "$@"; do
        case $argument in
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
