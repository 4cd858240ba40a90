/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "card.h"
#include "soon.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

struct card card = {.file = -1};

static void must(unsigned long request, void *argument, const char *what)
{
    if (ioctl(card.file, request, argument) != 0)
        fail_msg("%s: %s", what, strerror(errno));
}

static bool find_card(void)
{
    struct dirent **entries;
    const int count = scandir("/dev/dri", &entries, NULL, alphasort);
    for (int i = 0; i < count; i++) {
        char path[300];
        snprintf(path, sizeof path, "/dev/dri/%s", entries[i]->d_name);
        if (card.file < 0 && strncmp(entries[i]->d_name, "card", 4) == 0)
            card.file = open(path, O_RDWR | O_CLOEXEC);
        free(entries[i]);
    }
    if (count > 0)
        free(entries);
    return card.file >= 0;
}

void card_open(unsigned width, unsigned height)
{
    card.file = -1;
    for (unsigned looks = 0; !find_card();)
        if (!wait_more(&looks))
            fail_msg("the kernel makes no display of it");
    struct drm_mode_card_res resources = {.count_crtcs = 1, .count_connectors = 1};
    resources.crtc_id_ptr = (uintptr_t)&card.crtc;
    resources.connector_id_ptr = (uintptr_t)&card.connector;
    must(DRM_IOCTL_MODE_GETRESOURCES, &resources, "resources");
    assert_true(resources.count_crtcs == 1 && resources.count_connectors == 1);
    struct drm_mode_get_connector probe = {.connector_id = card.connector};
    must(DRM_IOCTL_MODE_GETCONNECTOR, &probe, "connector");
    assert_int_equal(probe.count_modes, 1);
    struct drm_mode_get_connector get = {.connector_id = card.connector, .count_modes = 1};
    get.modes_ptr = (uintptr_t)&card.mode;
    must(DRM_IOCTL_MODE_GETCONNECTOR, &get, "mode");
    assert_true(card.mode.hdisplay == width && card.mode.vdisplay == height);
}

void card_close(void)
{
    munmap(card.pixels, card.bytes);
    close(card.file);
    card.file = -1;
}

unsigned card_pixel_bytes(uint32_t fourcc)
{
    return fourcc == DRM_FORMAT_RGB565 ? 2 : fourcc == DRM_FORMAT_RGB888 ? 3 : 4;
}

void card_show(uint32_t fourcc)
{
    struct drm_mode_create_dumb create = {
        .width = card.mode.hdisplay, .height = card.mode.vdisplay, .bpp = 8 * card_pixel_bytes(fourcc)};
    must(DRM_IOCTL_MODE_CREATE_DUMB, &create, "buffer");
    struct drm_mode_fb_cmd2 add = {.width = card.mode.hdisplay, .height = card.mode.vdisplay, .pixel_format = fourcc};
    add.handles[0] = create.handle;
    add.pitches[0] = create.pitch;
    must(DRM_IOCTL_MODE_ADDFB2, &add, "frame buffer");
    struct drm_mode_map_dumb map = {.handle = create.handle};
    must(DRM_IOCTL_MODE_MAP_DUMB, &map, "map");
    card.pixels = mmap(NULL, create.size, PROT_READ | PROT_WRITE, MAP_SHARED, card.file, (off_t)map.offset);
    assert_true(card.pixels != MAP_FAILED);
    card.bytes = create.size;
    card.pitch = create.pitch;
    card.frame = add.fb_id;
    card.fourcc = fourcc;
    struct drm_mode_crtc set = {.crtc_id = card.crtc, .fb_id = add.fb_id, .count_connectors = 1, .mode_valid = 1};
    set.mode = card.mode;
    set.set_connectors_ptr = (uintptr_t)&card.connector;
    must(DRM_IOCTL_MODE_SETCRTC, &set, "mode");
}

void card_dirty(unsigned x, unsigned y, unsigned width, unsigned height)
{
    struct drm_clip_rect clip = {(unsigned short)x, (unsigned short)y, (unsigned short)(x + width),
                                 (unsigned short)(y + height)};
    struct drm_mode_fb_dirty_cmd dirty = {.fb_id = card.frame, .num_clips = 1, .clips_ptr = (uintptr_t)&clip};
    must(DRM_IOCTL_MODE_DIRTYFB, &dirty, "dirty");
}
