/* SPDX-License-Identifier: MIT
 * For Eva: models, formats and tables by their numbers, also those that there are not. Of what makes a paint of
 * them only this is said here: the uses that it is given are there, or NULL.
 * eva: -eva-precision 2 -eva-split-return-function glint_paint_check:0 -eva-use-spec glint_paint_tables_for,glint_paint_steps_for */
#include "eva.h"
#include "glint_tables.h"

/*@ requires \valid(paint) && \valid_read(material) && \valid_read(output);
    requires kind == \null || \valid_read(kind);
    requires model == \null || \valid_read(model);
    requires format == \null || \valid_read(format);
    assigns *paint, \result \from bytes; */
enum glint_err glint_paint_tables_for(struct glint_paint *paint, const struct glint_use_tables *kind,
                                      const struct glint_material *material, const struct glint_output *output,
                                      void *memory, size_t bytes, const struct glint_use_model *model,
                                      const struct glint_use_format *format);
/*@ requires \valid_read(format);
    assigns \result \from bytes; */
enum glint_err glint_paint_steps_for(struct glint_paint *paint, const struct glint_use_format *format, void *memory,
                                     size_t bytes);

static uint32_t memory[4];

void eva_paint_tables(void)
{
    struct glint_paint paint;
    struct glint_material material = any_material((uint8_t)any);
    const struct glint_output output = {(uint8_t)any, (uint8_t)any, any & 1};
    material.n = (uint16_t)any;
    material.n_across = (uint16_t)any;
    (void)glint_paint_tables(&paint, (enum glint_tables_kind)any, &material, &output, memory, any);
    (void)glint_paint_tables(&paint, (enum glint_tables_kind)any, NULL, &output, memory, any);
    (void)glint_paint_tables(&paint, (enum glint_tables_kind)any, &material, NULL, memory, any);
}
void eva_tables_bytes(void)
{
    (void)glint_tables_bytes((enum glint_tables_kind)any, any & 1);
}
void eva_paint_steps_by(void)
{
    struct glint_paint paint;
    paint.output.space = (uint8_t)any;
    (void)glint_paint_steps(&paint, memory, any);
    (void)glint_paint_steps(NULL, memory, any);
}
