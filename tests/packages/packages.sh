# SPDX-License-Identifier: MIT
# What the scripts of this folder share: sourced by them. After it $source is the project, $folder a scratch folder, $log what
# the last step printed, $library the host's library, $expected the values that example.c prints on the host.
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
log=$folder/log number=0
example=$source/tests/packages/example.c
version=$(sed -n 's/.*GLINT_VERSION_STRING "\(.*\)"/\1/p' "$source/lib/glint.h")
unset MAKEFLAGS MAKELEVEL

result() { # STATUS NAME
    number=$((number + 1))
    [ "$1" = 0 ] || { sed 's/^/# /' "$log"; printf not\ ; }
    echo "ok $number - $2"
}
finish() { echo "1..$number"; }

# The host's library and its values: what make all has built of the sources as they are, once for all scripts.
library=$(dirname "${GLINT:-$source/build/host/glint}")/libglint.a
[ -e "$library" ] || { echo "$0: there is no $library: run 'make' first" >&2; exit 1; }
"${CC:-cc}" -I"$source/lib" "$example" "$library" -o "$folder/expected" || exit 1
expected=$("$folder/expected")
prints() { # COMMAND...: it succeeds and prints the host's values and nothing else
    found=$("$@" 2>>"$log") && [ "$found" = "$expected" ] && return
    echo "expected '$expected', found '$found'" >>"$log"
    return 1
}

# A Cortex-M3: an image needs the port's start code, and is run by QEMU.
arm_flags="-mcpu=cortex-m3 -mthumb"
ports=$source/firmware/ports
bare="$ports/cortex-m/start.c $ports/cortex-m/machine.c $ports/bare/run.c $ports/bare/memory.c"
bare_flags="-DBARE -ffreestanding -I$source/firmware/ports/bare"
bare_link="-nostdlib -L$source/firmware/ports/bare -T$source/firmware/ports/cortex-m/mps2.ld"
run_arm() { # IMAGE
    timeout 60 qemu-system-arm -M mps2-an385 -display none -semihosting-config enable=on,target=native -kernel "$1" 2>&1
}
