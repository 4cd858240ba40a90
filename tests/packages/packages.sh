# SPDX-License-Identifier: MIT
# What the scripts of this folder share: sourced by them. After it $source is the project, $folder a scratch folder, $log what
# the last step printed, $library the host's library, $expected the values that example.c prints on the host.
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
log=$folder/log number=0
hangs=1800 # seconds: what is emulated has ended by then, or never does
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
run_arm() { # IMAGE [MACHINE]
    timeout $hangs qemu-system-arm -M "${2:-mps2-an385}" -display none -semihosting-config enable=on,target=native -kernel "$1" 2>&1
}
# An STM32F2 with 64 KB of RAM: run_arm IMAGE netduino2.
stm32_link="-nostdlib -L$source/firmware/ports/bare -T$source/tests/packages/netduino2.ld"

# Arduino: Debian's builder and core, with the libraries in standins/. What its package of the whole IDE would add: the builder's settings beside the
# core, and where the tools are. Beside that core lies standins/hardware, since Debian has a core for AVR alone: bare Cortex-M3s
# and M0+s (bare:arm:stm32, zero, feather), all run on an STM32F2.
standins=$source/tests/packages/standins core=$source/tests/packages/standins/hardware/bare/arm/cores/bare
standin_includes="-I$core -I$standins/libraries/Adafruit_GFX_Library -I$standins/libraries/TFT_eSPI -I$standins/libraries/Wire"
arduino_is_there() { command -v arduino-builder >/dev/null && [ -d /usr/share/arduino/hardware/arduino/avr ] && command -v simavr >/dev/null; }
arduino_build() { # BOARD SKETCH LIBRARIES BUILD
    hardware=$folder/hardware
    [ -d "$hardware" ] || { mkdir -p "$hardware/tools/avr" "$folder/cores" && cp -r "$standins/hardware/bare" "$hardware/" &&
        cp "$ports"/bare/*.[ch] "$ports/cortex-m/start.c" "$ports/cortex-m/machine.c" "$hardware/bare/arm/cores/bare/" &&
        ln -s /usr/share/arduino/hardware/arduino /usr/share/arduino-builder/platform*.txt "$hardware" && ln -s /usr/bin "$hardware/tools/avr/bin"; } || return
    rm -rf "$4" && mkdir "$4" && cp -r "$2" "$folder/" || return
    # Debian's core names a macro that its compiler does not define.
    arduino-builder -compile -hardware "$hardware" -tools "$hardware/tools" -libraries "$3" -libraries "$standins/libraries" -fqbn "$1" \
        -prefs=compiler.c.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__ -prefs=compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__ \
        -prefs=bare.flags="$bare_flags" -prefs=bare.link="$stm32_link" \
        -build-path "$4" -build-cache "$folder/cores" "$folder/$(basename "$2")/$(basename "$2").ino"
}
# What a sketch prints on a board, the lines that match the PATTERN, until there are LINES of them: simavr colours them, prints dots, and does not
# end by itself.
arduino_run() { # PART IMAGE LINES [PATTERN]
    pattern=${4:-'[0-9A-F]\{1,4\}'}
    timeout $hangs stdbuf -oL simavr -m "$1" -f 16000000 "$2" >"$folder/serial" 2>&1 &
    simulator=$!
    while kill -0 $simulator 2>/dev/null; do
        [ "$(arduino_printed | wc -l)" -lt "$3" ] || kill $simulator
        sleep .2
    done
    arduino_printed
}
arduino_printed() { tr -d '\033\r' <"$folder/serial" | sed -n "s/^[^0-9A-F]*\(\[[0-9]*m\)*\($pattern\)\.*\$/\2/p"; }
sketch_on_host() { # NAME PROGRAM: an example, with standins/
    # shellcheck disable=SC2086 # words
    "${CXX:-c++}" -Wall -Wextra -Werror -I"$source/lib" $standin_includes -include Arduino.h -x c++ "$1" "$core/arduino.cpp" "$standins"/libraries/*/*.cpp \
        -x none "$library" -o "$2"
}
line_pixels() { # FILE: what the example Line prints, from the host
    sketch_on_host "$source/lib/examples/Line/Line.ino" "$folder/line_on_host" && "$folder/line_on_host" >"$1" && [ "$(wc -l <"$1")" = 64 ]
}

# Projects of Zephyr's and ESP-IDF's users, for the stand-ins that standins/ has of their build systems.
export ZEPHYR_BASE="$source/tests/packages/standins/zephyr" IDF_PATH="$source/tests/packages/standins/idf"
zephyr_project() { # FOLDER PROGRAM; prj.conf is the caller's
    cat >"$1/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.20.0)
find_package(Zephyr REQUIRED HINTS \$ENV{ZEPHYR_BASE})
project(program LANGUAGES C)
target_sources(app PRIVATE $2)
END
}
idf_project() { # FOLDER PROGRAM; main/ and components/ are there
    cat >"$1/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.16)
include($ENV{IDF_PATH}/tools/cmake/project.cmake)
project(program)
END
    echo "idf_component_register(SRCS $2)" >"$1/main/CMakeLists.txt"
}
