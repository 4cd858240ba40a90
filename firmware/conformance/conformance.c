/* SPDX-License-Identifier: MIT */
#include "conformance.h"

#include "conformance_lobes.h"
#include "conformance_meshes.h"
#include "conformance_paints.h"
#include "conformance_random.h"
#include "conformance_scenes.h"
#include "conformance_tables.h"
#include "glint_port.h"
#include "machine.h"

const struct conformance_size conformance_large = {1, 7, 3000, 1, 40, 50000};
const struct conformance_size conformance_small = {4, 8191, 6, 4, 1, 20};

/* In flash, where AVR would have copies in its RAM. */
enum { NAME_BYTES = 42 };
static const char names[CONFORMANCE_HELD][NAME_BYTES] GLINT_FLASH = {
#define CONFORMANCE_IF_own(name) #name ": values, limits, cutoffs",
    GLINT_MODELS(CONFORMANCE_MODELS)
#undef CONFORMANCE_IF_own
        "models by number, prepared lobes",
#if !CONFORMANCE_MODELS_ONLY
    "vectors and lights",
    "sRGB",
#define CONFORMANCE_FORMAT(number, name, bits, channels, red, green, blue) "exact, exact-int8, span in " name,
    GLINT_FORMATS(CONFORMANCE_FORMAT) "no such format",
    "exact of meshes",
    "exact of meshes with colours",
    "exact of meshes under several lights",
    "exact of meshes with outlines",
    "exact of meshes with textures",
    "exact of meshes with grain",
    "tables under a light",
    "colour-int16, -int8, -span, palette",
    "colour-int16, -int8, -span, dithered",
    "colour of meshes",
    "albedo of meshes with colours",
    "albedo of meshes with textures",
    "colour and albedo of meshes with outlines",
    "albedo-int16, albedo-int8, albedo-span",
    "MSH and Schlick, every c, n = 1",
    "MSH and Schlick, every c, n = 2",
    "MSH and Schlick, every c, n = 3",
    "MSH and Schlick, every c, n = 5",
    "MSH and Schlick, every c, n = 10",
    "MSH and Schlick, every c, n = 60",
    "MSH and Schlick, every c, n = 100",
    "MSH and Schlick, every c, n = 317",
    "MSH and Schlick, every c, n = 1000",
#endif
};

const char *conformance_name(unsigned check)
{
    return names[check];
}

bool conformance_fits(unsigned check)
{
    if (check >= CONFORMANCE_HELD)
        return false;
    if (CONFORMANCE_ALBEDO_ONLY)
        return check == CONFORMANCE_TABLES_LIT || check == CONFORMANCE_MESHES_ALBEDO_TABLES ||
               check == CONFORMANCE_MESHES_TEXTURED_TABLES;
    if (check == CONFORMANCE_TABLES_LIT || check == CONFORMANCE_MESHES_OUTLINED)
        return CONFORMANCE_TABLES;
    if (check >= CONFORMANCE_COLOURS && check <= CONFORMANCE_ALBEDO)
        return CONFORMANCE_TABLES;
    return check < CONFORMANCE_EVERY_C_1 || CONFORMANCE_EVERY_C;
}

/* ---- the checks ---- */

/* No table of pointers: the stack's bound follows calls by name. */
uint64_t conformance_hash(unsigned check, const struct conformance_size *size)
{
    conform_begin();
    if (check == CONFORMANCE_TABLES_LIT && CONFORMANCE_TABLES && !CONFORMANCE_MODELS_ONLY)
        conform_tables_lit();
    else if (check == CONFORMANCE_MESHES_ALBEDO_TABLES && !CONFORMANCE_MODELS_ONLY)
        conform_mesh_by_albedo(size, false);
    else if (check == CONFORMANCE_MESHES_TEXTURED_TABLES && !CONFORMANCE_MODELS_ONLY)
        conform_mesh_by_albedo(size, true);
    else if (CONFORMANCE_ALBEDO_ONLY)
        ;
    else if (check < CONFORMANCE_LOBES)
        conform_model(check, size);
    else if (CONFORMANCE_MODELS_ONLY || check == CONFORMANCE_LOBES)
        conform_lobes(size);
    else if (check == CONFORMANCE_VECTORS)
        conform_vectors(size);
    else if (check == CONFORMANCE_SRGB)
        conform_srgb(size);
    else if (check <= CONFORMANCE_NO_FORMAT)
        conform_scenes(check - CONFORMANCE_FORMATS, size);
    else if (check == CONFORMANCE_MESHES)
        conform_meshes(size, false);
    else if (check == CONFORMANCE_MESHES_ALBEDO)
        conform_mesh_albedo(size);
    else if (check == CONFORMANCE_MESHES_LIT)
        conform_mesh_lights(size);
    else if (check == CONFORMANCE_MESHES_OUTLINED)
        conform_mesh_outlines(size, false);
    else if (check == CONFORMANCE_MESHES_TEXTURED)
        conform_mesh_textures(size);
    else if (check == CONFORMANCE_MESHES_GRAINED)
        conform_mesh_grain(size);
    else if (check == CONFORMANCE_COLOURS)
        conform_colours(size);
    else if (check == CONFORMANCE_DITHERED)
        conform_dithered(size);
    else if (check == CONFORMANCE_MESHES_COLOUR)
        conform_meshes(size, true);
    else if (check == CONFORMANCE_MESHES_OUTLINED_TABLES)
        conform_mesh_outlines(size, true);
    else if (check == CONFORMANCE_ALBEDO)
        conform_albedo(size);
    else
        conform_every_c(check);
    return conform_hash();
}

/* ---- the report ---- */

void conformance_say(const char *text)
{
    while (*text)
        machine_put(*text++);
}

void conformance_say_number(uint32_t number)
{
    char digits[10];
    uint8_t count = 0;
    do
        digits[count++] = (char)('0' + number % 10);
    while (number /= 10);
    while (count)
        machine_put(digits[--count]);
}

static void say_name(unsigned check)
{
    for (const char *at = names[check]; GLINT_FLASH_U8(*at); at++)
        machine_put((char)GLINT_FLASH_U8(*at));
}

static void say_hash(uint64_t value)
{
    for (uint8_t digit = 0; digit < 16; digit++) {
        const unsigned nibble = value >> (60 - 4 * digit) & 15;
        machine_put((char)(nibble < 10 ? '0' + nibble : 'a' + nibble - 10));
    }
}

struct conformance_sum conformance_run(const uint64_t expected[CONFORMANCE_HELD])
{
    struct conformance_sum sum = {0, 0, 0};
    for (unsigned check = 0; check < CONFORMANCE_CHECKS; check++) {
        const bool fits = conformance_fits(check);
        const uint64_t found = fits ? conformance_hash(check, &conformance_small) : 0;
        const bool good = !fits || found == expected[check];
        sum.skipped += !fits;
        sum.passed += fits && good;
        sum.failed += !good;
        conformance_say(good ? "ok " : "not ok ");
        conformance_say_number(check + 1);
        conformance_say(" - ");
        if (check < CONFORMANCE_HELD)
            say_name(check);
        else
            conformance_say("another check");
        if (!fits)
            conformance_say(" # SKIP too large for this machine");
        else {
            conformance_say(": ");
            say_hash(found);
        }
        if (!good) {
            conformance_say(", the host has ");
            say_hash(expected[check]);
        }
        conformance_say("\n");
    }
    return sum;
}
