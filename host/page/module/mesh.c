/* SPDX-License-Identifier: MIT */
#include "mesh.h"

#include <stdlib.h>

#include "draw/canvas.h"
#include "draw/mesh_canvas.h"
#include "mesh/load.h"
#include "page.h"

static struct page_mesh kept;

const struct page_mesh *page_mesh(void)
{
    return kept.mesh ? &kept : NULL;
}

static void forget_canvas(void)
{
    mesh_canvas_free(kept.canvas);
    free(kept.behind);
    free(kept.shadings);
    free(kept.now);
    kept.canvas = NULL;
    kept.behind = NULL;
    kept.shadings = kept.now = NULL;
}

void mesh_forget(void)
{
    forget_canvas();
    fitted_free(kept.fitted);
    mesh_free(kept.mesh);
    kept = (struct page_mesh){.mesh = NULL};
}

static struct shading *shadings_of(const struct shading_options *look)
{
    const struct shading shading = shading_of_options(look, look->shading.format, &plain_finish);
    return mesh_shadings(kept.mesh, &shading, shading_options_own(look));
}

struct shading mesh_draw(const struct shading_options *look, uint32_t width, uint32_t height, uint32_t keep,
                         uint8_t *pixels)
{
    if (keep < PAGE_KEEP_SCENE) {
        mesh_forget();
        kept.mesh = mesh_load(&look->scene.mesh);
        kept.fitted = mesh_fit(kept.mesh, 0);
        shading_options_grain(look, kept.fitted);
        if (shading_options_one_color(look))
            fitted_forget_colors(kept.fitted);
        if (look->scene.mesh.stepped)
            fitted_forget_neighbours(kept.fitted);
    }
    if (keep < PAGE_KEEP_CANVAS) {
        forget_canvas();
        kept.shadings = shadings_of(look);
        kept.canvas = mesh_canvas_new(kept.fitted, kept.shadings);
        uint8_t *rgb = scene_backdrop(&look->scene, width, height);
        kept.behind = backdrop_pixels(rgb, width, height, kept.shadings);
        free(rgb);
        mesh_canvas_set_backdrop(kept.canvas, kept.behind);
    }
    free(kept.now);
    kept.now = shadings_of(look);
    kept.view = view_of_options(&look->view, width, height, look->scene.mesh.built_in);
    mesh_draw_again(pixels);
    return kept.now[0];
}

void mesh_draw_stepped(uint8_t *pixels)
{
    mesh_canvas_draw_stepped(kept.canvas, &kept.view, pixels);
}

void mesh_draw_again(uint8_t *pixels)
{
    mesh_canvas_draw(kept.canvas, &kept.view, kept.now, pixels);
}
