# SPDX-License-Identifier: MIT
# Ports without an operating system build the conformance image. A port.mk says NAME_TOOLS, NAME_BOARDS, for each board
# NAME_FLAGS_BOARD (the compiler's) and NAME_LINK_BOARD (the linker's), and calls bare_port; BOARD= chooses one of its boards.
# Sources beside lib/, conformance/ and the port's own: NAME_BARE, NAME_ASSEMBLY_BOARD.
BARE = firmware/ports/bare
BARE_FLAGS = -std=c99 -ffreestanding -Os -ffunction-sections -fdata-sections -fstack-usage $(WARNINGS)
BARE_INCLUDE = lib firmware/conformance $(BARE) $(CONFORMANCE)
BARE_INPUTS = $(wildcard lib/* $(BARE)/*) $(CONFORMANCE_INPUTS) firmware/conformance/image.c $(CONFORMANCE_EXPECTED)

define bare_port
$(1)_SOURCES = $$(wildcard lib/*.c) $$(CONFORMANCE_SOURCES) firmware/conformance/image.c $$(wildcard firmware/ports/$(1)/*.c) $$($(1)_BARE)
firmware-$(1): $$(patsubst %,firmware-$(1)-%,$$(or $$(BOARD),$$($(1)_BOARDS)))
firmware-$(1)-%:
	@echo "make: port $(1) has no board $$*, but $$($(1)_BOARDS)" >&2; exit 1
$$(foreach board,$$($(1)_BOARDS),$$(eval $$(call bare_board,$(1),$$(board),build/firmware/$(1)-$$(board))))
.PHONY: firmware-$(1) $$($(1)_BOARDS:%=firmware-$(1)-%)
endef

# The linker's words are left beside the objects: tests link these anew, with a fault.
define bare_board
firmware-$(1)-$(2): $(3)/conformance.elf
	@$$($(1)_TOOLS)size $$< | awk 'NR == 2 { printf "$$<: %d bytes of flash, %d of RAM without stack\n", $$$$1 + $$$$2, $$$$2 + $$$$3 }'
$(3)/conformance.elf: $$($(1)_SOURCES) $$(BARE_INPUTS) $$(wildcard firmware/ports/$(1)/*)
	@rm -rf $(3) && mkdir -p $(3)
	@cd $(3) && $$($(1)_TOOLS)gcc $$(BARE_FLAGS) $$($(1)_FLAGS_$(2)) $$(addprefix -I,$$(abspath $$(BARE_INCLUDE))) -c \
		$$(abspath $$($(1)_SOURCES) $$($(1)_ASSEMBLY_$(2)))
	@echo '$$($(1)_FLAGS_$(2)) -Wl,--gc-sections -L$$(abspath $$(BARE)) $$($(1)_LINK_$(2))' >$(3)/link
	@$$($(1)_TOOLS)gcc @$(3)/link $(3)/*.o -lgcc -o $$@
endef
