# SPDX-License-Identifier: MIT
"""What a program links: functions alone, with all they need (libgcc's and libc's helpers, too) and nothing else."""
import glob
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "targets"))
from targets import SOURCE, library_sources  # noqa: E402

with open(os.path.join(SOURCE, "lib/glint.h")) as header: # the models that have functions of their own
    OWN = re.findall(r"^ +X\(GLINT_\w+, (\w+), \w+, own[,)]", header.read(), re.M)
FUNCTIONS = [f"glint_{model}{end}" for model in OWN for end in ("", "_t")] + """
glint_msh+glint_msh_cutoff glint_msh_t+glint_msh_cutoff_t glint_lobe_init+glint_lobe_eval_t
glint_paint_exact+glint_light_directional+glint_paint_light_by+glint_draw_rect_by
glint_paint_exact+glint_light_directional+glint_paint_light_by+glint_span_init+glint_draw_span_by
glint_paint_exact+glint_light_point+glint_light_spot+glint_paint_light_by+glint_draw_rect_by
glint_paint_tables+glint_light_directional+glint_paint_light_by+glint_draw_rect_by glint_draw_palette
peer_blinn_powf peer_schlick_float peer_msh_float""".split()
# Rectangles of one model and one kind of pixel, or one kind of tables, under a directional light, with all set-up.
_DIRECTIONAL = "+glint_light_directional+glint_paint_light_by+glint_draw_rect_by+"
RECTANGLES = ["glint_paint_exact_for" + _DIRECTIONAL + pair for pair in (
    "glint_use_rgb565+glint_use_msh", "glint_use_rgb565+glint_use_cayley", "glint_use_rgb888+glint_use_msh",
    "glint_use_linear+glint_use_msh")] + ["glint_paint_tables_for" + _DIRECTIONAL + names for names in (
    "glint_use_colour+glint_use_rgb565+glint_use_msh", "glint_use_albedo+glint_use_rgb565+glint_use_msh")]
# Meshes by one paint, with all set-up.
MESHES = ["glint_mesh_begin+glint_mesh_add+glint_mesh_strip+glint_light_directional+glint_paint_light_by+" + names for names in (
    "glint_paint_tables_for+glint_use_colour+glint_use_rgb565+glint_use_msh", "glint_paint_exact_for+glint_use_rgb565+glint_use_msh")]
FIXMATH_FUNCTIONS = ["peer_blinn_fixmath", "peer_schlick_fixmath", "peer_msh_fixmath"]
# Sections that are in flash; AVR's constants are in .data.
TEXT = re.compile(r"^\.(?:text|rodata|srodata|data|sdata)\S*\s+(\d+)", re.M)
IN_MAP = re.compile(r"^ \.(?:text|rodata|data)\S*\s+0x[0-9a-f]+\s+0x([0-9a-f]+) \S*?([^/(]+\.o)\)?$", re.M)


def fixmath(folder):
    """Its sources, if they could be had."""
    sources = [os.path.join(folder, "fixmath/libfixmath", name) for name in ("fix16.c", "fix16_exp.c")]
    return sources if all(map(os.path.exists, sources)) else []


def libc(target):
    return ["--specs=picolibc.specs"] if target.name.startswith("rv") else []


def objects(target, level, folder, place, peers=()):
    """The library and the peers; and where a program may be linked."""
    place = os.path.join(folder, place, target.name + level)
    os.makedirs(place, exist_ok=True)
    for old in glob.glob(place + "/*.o"):
        os.remove(old)
    sources = [os.path.join(SOURCE, path) for path in library_sources() + ["tests/bench/peers.c"]] + list(peers)
    for source in sources:  # one at a time: ccache knows only such compilations
        target.tool("gcc", "-std=gnu99", level, "-ffunction-sections", "-fdata-sections", *target.flags.split(), *libc(target),
                    "-DFIXMATH_NO_CACHE", "-I" + SOURCE + "/lib", f"-I{folder}/fixmath", "-c", source, cwd=place)
    return glob.glob(place + "/*.o"), os.path.join(place, "alone.elf")


def link(target, level, files, elf, functions):
    """Bytes of code and constants; and how many of them each object file gives, by the link map."""
    script = ["-T", os.path.join(SOURCE, "tests/bench/m0plus.ld")] if target.name.startswith("cortex") else []
    target.tool("gcc", level, *target.flags.split(), *libc(target), "-nostartfiles", *script, "-Wl,--gc-sections,-Map," + elf + ".map",
                *["-Wl,-u," + name for name in functions], "-Wl,-e," + functions[0], *files, "-lm", "-o", elf)
    with open(elf + ".map") as text:
        linked = text.read().split("Linker script and memory map")[1].replace("\n                0x", " 0x")
    share = {}
    for size, name in IN_MAP.findall(linked):
        if int(size, 16):
            share[name] = share.get(name, 0) + int(size, 16)
    return sum(map(int, TEXT.findall(target.tool("size", "-A", elf)))), share
