# setup.sh -- sourced by ./run and ./test: installs what is missing, configures, builds.
#
#   need PACKAGE...            installs the Debian packages that are missing, or says how and exits 2
#   build PRESET [TARGET]      configures (once) and builds build/PRESET, or one target of it

say() { printf '%s\n' "$*"; }

# Debian packages by name.  On another system nothing is installed: CMake names what it misses.
need() {
    command -v dpkg-query >/dev/null 2>&1 || return 0
    missing=
    for package in "$@"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing="$missing $package"
    done
    [ -z "$missing" ] && return 0
    if [ "$(id -u)" = 0 ]; then
        as_root=
    elif command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
        as_root=sudo
    else
        say "Some packages are missing.  Type this, then start again:"
        say "  su -c 'apt-get update && apt-get install -y --no-install-recommends$missing'"
        exit 2
    fi
    say "Installing:$missing"
    # shellcheck disable=SC2086
    $as_root apt-get update -qq &&
        DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing >"$log" 2>&1 ||
        { tail -20 "$log"; say "The installation failed; its output is in $log"; exit 2; }
}

processors() { nproc 2>/dev/null || echo 2; }

build() {
    preset=$1 target=${2:-all}
    [ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" >"$log" 2>&1 ||
        { cat "$log"; say "Configuration failed"; exit 2; }
    if [ -t 1 ]; then
        cmake --build "build/$preset" --target "$target" -j "$(processors)" || { say "The build failed"; exit 3; }
    else
        cmake --build "build/$preset" --target "$target" -j "$(processors)" >"$log" 2>&1 ||
            { tail -60 "$log"; say "The build failed"; exit 3; }
    fi
}

mkdir -p build
log=build/log.txt
libraries="libgmp-dev libmpfr-dev libflint-dev libflint-arb-dev libcalcium-dev libjansson-dev libxml2-dev libceres-dev libmimalloc-dev"
tools="gcc g++ libc6-dev cmake ninja-build pkg-config"
