# ./braidx test: C++ tests through ctest, then Python tests through pytest; fails if either does.

run_tests() {
    local folders=() options=() argument cpp='not run' py code=0
    for argument in "$@"; do
        case $argument in
        --verification | --stability | --benchmark | --studies) folders+=("tests/${argument#--}") ;;
        *) options+=("$argument")
            [ -e "$checkout/${argument%%::*}" ] && [ "${argument#-}" = "$argument" ] && folders+=("") ;;
        esac
    done
    cd "$checkout"
    if [ ${#folders[@]} = 0 ]; then
        build all
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
