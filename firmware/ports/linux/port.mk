# SPDX-License-Identifier: MIT
# A Linux board with a USB device controller: glint-gadget. CC may be a cross compiler.
linux_PACKAGES = gcc libc6-dev libpng-dev pkg-config
linux_CFLAGS = -std=c11 -D_GNU_SOURCE $(WARNINGS) -MMD -MP -Ilib -Ifirmware/core -Ifirmware/ports/linux -pthread $(CFLAGS)
linux_CORE = gud_device gud_reply gud_rectangle gud_pixels gud_protocol lz4_block
linux_OBJECTS = $(patsubst firmware/ports/linux/%.c,$(linux)/%.o,$(wildcard firmware/ports/linux/*.c)) \
	$(linux_CORE:%=$(linux)/core/%.o)
linux = build/firmware/linux

have-linux-choices:
	@$(foreach choice,BOARD PANEL,$(if $(filter command,$(origin $(choice))),$(if $(filter linux,$(PORT)),echo "make: $(choice)=$($(choice)): port linux takes none$(COMMA) and glint-gadget its --size when it runs; leave $(choice) out" >&2; exit 1;)))
firmware-linux: have-linux-choices $(linux)/glint-gadget

$(linux)/glint-gadget: $(linux_OBJECTS) $(linux)/flags
	$(CC) $(linux_CFLAGS) $(LDFLAGS) $(filter %.o,$^) -o $@ -lpng

$(linux)/core/%.o: firmware/core/%.c $(linux)/flags
	@mkdir -p $(@D)
	$(CC) -Ilib $(LIB_CFLAGS) -c $< -o $@

$(linux)/%.o: firmware/ports/linux/%.c $(linux)/flags
	@mkdir -p $(@D)
	$(CC) $(linux_CFLAGS) -c $< -o $@

# As $(BUILD)/flags.
linux_FLAGS = $(CC) $(linux_CFLAGS) $(LIB_CFLAGS) $(LDFLAGS)
$(linux)/flags: always
	@mkdir -p $(@D)
	@printf '%s\n' $(call quoted,$(linux_FLAGS)) | cmp -s - $@ || printf '%s\n' $(call quoted,$(linux_FLAGS)) >$@

.PHONY: firmware-linux have-linux-choices

# For the lab's tests of hosts: the same, with faults.
$(linux)/faulty-gadget: $(linux)/faulty_gadget.o $(filter-out %/main.o,$(linux_OBJECTS)) $(linux)/flags
	$(CC) $(linux_CFLAGS) $(LDFLAGS) $(filter %.o,$^) -o $@ -lpng

$(linux)/faulty_gadget.o: tests/lab/faulty_gadget.c $(linux)/flags
	@mkdir -p $(@D)
	$(CC) $(linux_CFLAGS) -c $< -o $@
