/* SPDX-License-Identifier: MIT
 * A fault that the fuzzer of the virtual panel is to find. */
#include "fault.h"
#include "sinks/panel/virtual_panel.h"

void __real_virtual_panel_data(struct virtual_panel *panel, const uint8_t *bytes, size_t count);
void __wrap_virtual_panel_data(struct virtual_panel *panel, const uint8_t *bytes, size_t count);

/* Writes the next pixel wherever it lies. */
void __wrap_virtual_panel_data(struct virtual_panel *panel, const uint8_t *bytes, size_t count)
{
    __real_virtual_panel_data(panel, bytes, count);
    if (fault_is("virtual_panel_data") && panel->command == PANEL_MEMORY_WRITE && count)
        panel->memory[panel->row][panel->column] = bytes[0];
}
