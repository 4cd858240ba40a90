# SPDX-License-Identifier: MIT
# Gateware: rtl/ has one module a file, demo/ what the demo adds to it, boards/NAME a board's top module, its pins (NAME.pcf) and NAME.mk, which sets
# NAME_TOP, NAME_DEVICE (nextpnr's options) and NAME_MHZ, the clock that must be met.
GATEWARE = build/gateware
GATEWARE_RTL = $(wildcard firmware/gateware/rtl/*.v)
GATEWARE_DEMO = $(wildcard firmware/gateware/demo/*.v)
GATEWARE_BOARDS = $(patsubst firmware/gateware/boards/%/,%,$(sort $(dir $(wildcard firmware/gateware/boards/*/*.mk))))
GATEWARE_PACKAGES = yosys nextpnr-ice40 fpga-icestorm python3-minimal
GATEWARE_TABLES = $(BUILD)/gateware/tables
# MODULE:PART[:NAME=VALUE,...], see firmware/gateware/report.
GATEWARE_REPORT = glint_core:up5k glint_lite:up5k glint_span:up5k glint_span:up5k:WHITE=1 glint_core:hx8k glint_lite:hx8k glint_lite:hx1k
GATEWARE_UNROUTED = glint_core:ecp5:LUT_RAM=1 glint_lite:ecp5:LUT_RAM=1 glint_span:ecp5:LUT_RAM=1 glint_core:xilinx:LUT_RAM=1,ROW_AND=1 \
	glint_lite:xilinx:LUT_RAM=1,ROW_AND=1 glint_span:xilinx:LUT_RAM=1,ROW_AND=1 glint_core:gowin:LUT_RAM=1 glint_lite:gowin:LUT_RAM=1 glint_span:gowin:LUT_RAM=1
include $(wildcard firmware/gateware/boards/*/*.mk)

gateware: $(GATEWARE_BOARDS:%=$(GATEWARE)/%.bin) ## firmware: bitstreams into build/gateware, one for each of firmware/gateware/boards

setup-gateware-tools:
	@.ci/need "gateware (synthesis, place and route)" $(GATEWARE_PACKAGES)

define gateware_board
$(GATEWARE)/$(1).json: $(GATEWARE_RTL) $(GATEWARE_DEMO) $(wildcard firmware/gateware/boards/$(1)/*.v) firmware/gateware/boards/$(1)/$(1).mk | setup-gateware-tools
	@mkdir -p $$(@D)
	@yosys -q -l $(GATEWARE)/$(1).yosys.log -p "synth_ice40 -dsp -top $($(1)_TOP) -json $$@" $$(filter %.v,$$^) || { rm -f $$@; exit 1; }

# A clock that is not met is an error, and leaves no bitstream.
$(GATEWARE)/$(1).asc: $(GATEWARE)/$(1).json firmware/gateware/boards/$(1)/$(1).pcf
	@nextpnr-ice40 -q -l $(GATEWARE)/$(1).nextpnr.log $($(1)_DEVICE) --freq $($(1)_MHZ) --pcf $$(lastword $$^) --json $$< --asc $$@ || \
		{ rm -f $$@; echo "make: $$@: not placed, or too slow: $(GATEWARE)/$(1).nextpnr.log tells" >&2; exit 1; }
endef
$(foreach board,$(GATEWARE_BOARDS),$(eval $(call gateware_board,$(board))))

$(GATEWARE)/%.bin: $(GATEWARE)/%.asc
	@icepack $< $@ && echo "$@: $$(wc -c <$@) bytes" && \
		sed -n 's/^Info:[ \t]*\(ICESTORM_LC\|ICESTORM_RAM\|ICESTORM_DSP\):/  \1/p' $(@:.bin=.nextpnr.log) && \
		sed -n 's/^Info: \(Max frequency\)/  \1/p' $(@:.bin=.nextpnr.log) | tail -1

gateware-report: setup-gateware-tools ## measure: what the gateware takes on iCE40 parts, into firmware/gateware/README.md
	@firmware/gateware/report -r firmware/gateware/README.md -w $(GATEWARE)/report $(GATEWARE_REPORT)

gateware-parts: setup-gateware-tools ## measure: what it takes on ECP5, Xilinx and Gowin parts, into the same file (five minutes)
	@firmware/gateware/report -r firmware/gateware/README.md -w $(GATEWARE)/report $(GATEWARE_UNROUTED)

# The demo's tables, of the library's values; a test tells when those in the tree are not what this program writes.
$(GATEWARE_TABLES): firmware/gateware/demo/tables.c $(BUILD)/firmware/core/orbit.o $(BUILD)/libglint.a
	@mkdir -p $(@D)
	@$(CC) -Ilib -Ifirmware/core $(LIB_CFLAGS) $(LDFLAGS) $^ -o $@

gateware-tables: $(GATEWARE_TABLES)
	$< orbit >$<.v && mv $<.v firmware/gateware/demo/glint_orbit.v
	$< chord >$<.v && mv $<.v firmware/gateware/demo/glint_chord.v

# What is made of the list of registers; a test tells when it is not.
gateware-registers:
	@cd firmware/gateware && registers/generate verilog >rtl/glint_registers.v && \
		registers/generate header >registers/glint_span_unit.h && registers/generate table >registers/README.md

.PHONY: gateware gateware-parts gateware-report gateware-registers setup-gateware-tools gateware-tables
