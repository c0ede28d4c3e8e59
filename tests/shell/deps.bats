#!/usr/bin/env bats
# SPDX-License-Identifier: GPL-3.0-or-later
# 'make deps' under other package managers, which are scripts here.

load common

# Puts fake package managers into $PWD/bin. Each prints its arguments, and reports that only gsl is installed.
managers() {
    mkdir bin
    for manager in apt-get dnf pacman apk brew pkg dpkg-query rpm sudo; do
        cat >"bin/$manager" <<'END'
#!/bin/sh
case "${0##*/} $*" in
sudo*) exec "$@" ;;
dpkg-query*libgsl-dev | 'rpm -q'*gsl-devel | 'pacman -Q gsl' | 'apk info -e gsl-dev' | 'brew list --versions gsl' | 'pkg info -e gsl')
    echo 'install ok installed' ;;
dpkg-query* | rpm* | 'pacman -Q'* | *info* | *list*) exit 1 ;;
*) echo "${0##*/} $*" >>asked ;;
esac
END
        chmod +x "bin/$manager"
    done
    PATH=$PWD/bin:$PATH
}

@test "make deps installs only what is missing, by the name that the package has on the system" {
    managers
    while IFS='|' read -r MANAGER asked; do
        rm -f asked
        export MANAGER
        "$root/.packaging/deps" libgsl-dev libreadline-dev bats gnuplot-nox
        same "$MANAGER" "$asked" "$(paste -sd '|' asked | sed 's/|/ then /')"
        rm asked
        "$root/.packaging/deps" libgsl-dev
        [ ! -e asked ]
    done <<'END'
apt-get|apt-get update -qq then apt-get install -y -qq --no-install-recommends libreadline-dev bats gnuplot-nox
dnf|dnf install -y readline-devel bats gnuplot-minimal
pacman|pacman -S --needed --noconfirm readline bats gnuplot
apk|apk add readline-dev bats gnuplot
brew|brew install readline bats-core gnuplot
pkg|pkg install -y readline bats-core gnuplot-lite
END
}

@test "deps knows every package of the Makefile, and uses sudo if the user is not root" {
    for goal in run test faults fuzz bench verify lint valgrind; do
        make -s -C "$root" -pn deps $goal 2>/dev/null | sed -n 's/^NEEDED := //p'
    done | tr ' ' '\n' | sort -u >needed
    [ "$(wc -l <needed)" -gt 20 ]
    managers
    echo 'echo 1000' >bin/id
    chmod +x bin/id
    run -0 env MANAGER=pacman "$root/.packaging/deps" $(cat needed)
    same 'no line' 'pacman has no package for: clang-format clang-tidy dpkg-dev libc6-dbg lintian musl-tools' "$(grep '^pacman has' <<<"$output")"
    same 'with sudo' 'running: sudo pacman -S --needed --noconfirm readline' \
        "$(MANAGER=pacman "$root/.packaging/deps" libreadline-dev | head -n 1)"
}
