# Keeps the contact engine built: CMake and Ninja, Release, in the user's cache. One build folder per checkout,
# environment and options; Ninja decides what is out of date.

build_folder() {
    build=$cache/build/$(printf '%s\n' "$checkout" "$environment" "${BRAIDX_CMAKE_ARGS:-}" | sha1sum | cut -c 1-12)
}

# Sources with their contents. Times tell nothing where a cache is older or newer than a checkout beside it.
sources() {
    find "$checkout/CMakeLists.txt" "$checkout/contact_engine" "$checkout/tests/cpp" -type f -exec sha1sum {} + | sort
}

# True if a source file changed since the last build of the target: saves the start of Ninja. Ninja goes by times, so that
# those files are touched.
out_of_date() {
    local changed
    sources >"$build/$1.started"
    cmp -s "$build/$1.started" "$build/$1.built" && return 1
    if [ -f "$build/$1.built" ]; then
        mapfile -t changed < <(comm -23 "$build/$1.started" "$build/$1.built" | cut -c 43-)
        [ ${#changed[@]} = 0 ] || touch -- "${changed[@]}" || stop "the sources in $checkout cannot be written"
    fi
}

# build TARGET: braidx_engine, or all (with the C++ tests). Sets `build`, the folder that holds the module.
build() {
    local arguments
    build_folder
    mkdir -p "$build"
    lock "$build/lock" "another braidx is building the engine"
    if ! [ -f "$build/build.ninja" ]; then
        read -ra arguments <<<"${BRAIDX_CMAKE_ARGS:-}"
        step "configuring the engine" "${inside[@]}" cmake -S "$checkout" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
            -DBRAIDX_TESTS=ON -DPython_EXECUTABLE="$python" "${arguments[@]}" ||
            { rm -f "$build/build.ninja"; stop "CMake failed (output above)"; }
    fi
    if out_of_date "$1"; then
        step "building ${1/#all/the engine and its C++ tests}" "${inside[@]}" ninja -C "$build" "$1" ||
            stop "the build failed (output above)"
        mv "$build/$1.started" "$build/$1.built"
    fi
    unlock
}
