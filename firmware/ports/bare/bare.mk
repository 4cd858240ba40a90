# SPDX-License-Identifier: MIT
# Boards without an operating system build the conformance image. A port's port.mk holds all facts about its boards and ends
# with $(eval $(call bare_port,NAME)):
#   NAME_BOARDS                the boards' names
#   NAME_TOOLS                 prefix of the compiler's tools
#   NAME_SOURCES               C sources beside lib/, conformance/ and the port's folder: $(BARE_START) for start.c, machine.c
#   NAME_LINK                  words for the linker before each board's script
#   NAME_RUN                   emulator that takes an image, with % for the board's name; NAME_RUN_BOARD where a board differs
#   NAME_CORE_BOARD            name of the processor core
#   NAME_FLAGS_BOARD           the compiler's flags for that core
#   NAME_SCRIPT_BOARD          linker script, in the port's folder
#   NAME_STACK                 bytes of stack that any call of the library may take, as glint.h states it; NAME_STACK_BOARD where a board differs
# and where it applies
#   NAME_IMAGE_BOARD           what the image leaves out: -DCONFORMANCE_TABLES=0, ... (conformance.h)
#   NAME_SKIPS_BOARD           how many checks that may skip, at most
#   NAME_ASSEMBLY_BOARD        assembly of the library
#   NAME_PUSHED_BOARD          bytes that a call pushes by itself
# The build, the tests of tests/targets, make bench and make boards read them here; BOARD= chooses one board.
BARE = firmware/ports/bare
BARE_START = $(BARE)/run.c $(BARE)/memory.c
# Without jump tables a jump to a register is a call through a pointer, never a switch: the check of the stack needs that.
BARE_FLAGS = -std=c99 -ffreestanding -Os -ffunction-sections -fdata-sections -fstack-usage -fno-jump-tables $(WARNINGS)
BARE_INCLUDE = lib firmware/conformance $(BARE) $(CONFORMANCE)
BARE_INPUTS = $(wildcard lib/* $(BARE)/*) $(CONFORMANCE_INPUTS) firmware/conformance/image.c $(CONFORMANCE_EXPECTED)
BARE_PORTS :=
BARE_BOARDS :=

# What an entry lacks, for port and board; and the end of make where it lacks anything.
bare_lacks = $(strip $(if $($(1)_TOOLS),,$(1)_TOOLS) \
	$(foreach fact,CORE FLAGS SCRIPT,$(if $(strip $($(1)_$(fact)_$(2))),,$(1)_$(fact)_$(2))) $(if $($(1)_STACK)$($(1)_STACK_$(2)),,$(1)_STACK))
bare_complete = $(if $(bare_lacks),$(error firmware/ports/$(1)/port.mk: board $(2): not set: $(bare_lacks); firmware/ports/bare/bare.mk says what each is))$(if \
	$(wildcard firmware/ports/$(1)/$($(1)_SCRIPT_$(2))),,$(error firmware/ports/$(1)/port.mk: $(1)_SCRIPT_$(2): there is no file firmware/ports/$(1)/$($(1)_SCRIPT_$(2))))

define bare_port
$$(if $$($(1)_BOARDS),,$$(error firmware/ports/$(1)/port.mk: not set: $(1)_BOARDS; firmware/ports/bare/bare.mk says what it is))
BARE_PORTS += $(1)
BARE_BOARDS += $$($(1)_BOARDS)
$(1)_INPUTS = $$(wildcard lib/*.c) $$(CONFORMANCE_SOURCES) firmware/conformance/image.c $$(wildcard firmware/ports/$(1)/*.c) $$($(1)_SOURCES)
firmware-$(1): $$(patsubst %,firmware-$(1)-%,$$(or $$(BOARD),$$($(1)_BOARDS)))
firmware-$(1)-%:
	@echo "make: port $(1) has no board $$*; choose from $$($(1)_BOARDS)" >&2; exit 1
$$(foreach board,$$($(1)_BOARDS),$$(eval $$(call bare_board,$(1),$$(board),build/firmware/$(1)-$$(board))))
.PHONY: firmware-$(1) $$($(1)_BOARDS:%=firmware-$(1)-%)
endef

# One source at a time, by words that tests/targets/targets.py has, too: ccache, if it is there, gives tests of the library these objects.
# The linker's words stay beside the objects: tests link these again, with a fault.
define bare_board
$$(call bare_complete,$(1),$(2))
bare_goal_$(2) = firmware-$(1)-$(2)
bare_image_$(2) = $(3)/conformance.elf
bare_line_$(2) = $(1)|$(2)|$$($(1)_CORE_$(2))|$$($(1)_TOOLS)|$$($(1)_FLAGS_$(2))|$$(or $$($(1)_SKIPS_$(2)),0)|$$($(1)_ASSEMBLY_$(2))|$$(or $$($(1)_PUSHED_$(2)),0)|$$(or $$($(1)_STACK_$(2)),$$($(1)_STACK))|$$($(1)_SOURCES)|$$(subst %,$(2),$$(or $$($(1)_RUN_$(2)),$$($(1)_RUN)))
firmware-$(1)-$(2): $(3)/conformance.elf
	@$$($(1)_TOOLS)size $$< | awk 'NR == 2 { printf "$$<: %d bytes of flash, %d of RAM without stack\n", $$$$1 + $$$$2, $$$$2 + $$$$3 }'
$(3)/conformance.elf: $$($(1)_INPUTS) $$(BARE_INPUTS) $$(wildcard firmware/ports/$(1)/*)
	@rm -rf $(3) && mkdir -p $(3)
	@cd $(3) && for source in $$(abspath $$($(1)_INPUTS) $$($(1)_ASSEMBLY_$(2))); do \
		$$($(1)_TOOLS)gcc $$(BARE_FLAGS) $$($(1)_FLAGS_$(2)) $$($(1)_IMAGE_$(2)) $$(addprefix -I,$$(abspath $$(BARE_INCLUDE))) -c $$$$source || exit 1; done
	@echo '$$($(1)_FLAGS_$(2)) -Wl,--gc-sections -L$$(abspath $$(BARE)) $$($(1)_LINK) $$(abspath firmware/ports/$(1)/$$($(1)_SCRIPT_$(2)))' >$(3)/link
	@$$(BARE)/link $(1) $(2) '$$($(1)_IMAGE_$(2))' $$($(1)_TOOLS)gcc @$(3)/link $(3)/*.o -lgcc -o $$@
endef

# One line a board, for programs; written again only where it changes.
BOARDS = build/firmware/boards
$(BOARDS): always
	@mkdir -p $(@D)
	@printf '%s\n' 'port|board|core|tools|flags|skips|assembly|pushed|stack|sources|run' $(foreach board,$(BARE_BOARDS),'$(bare_line_$(board))') >$@.tmp
	@cmp -s $@.tmp $@ && rm $@.tmp || mv $@.tmp $@

boards: $(BOARDS) ## firmware: the boards without an operating system: port, processor core, emulator
	@awk -F'|' '{ printf "%-10s %-12s %-18s %s\n", $$1, $$2, $$3, $$11 }' $<

.PHONY: boards
