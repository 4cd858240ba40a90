# SPDX-License-Identifier: MIT
# make bench-hazard3 HAZARD3=FOLDER: cycles of the RP2350's RISC-V core, from the Verilog in a checkout of github.com/Wren6991/Hazard3, of which
# nothing is kept here.
BENCH_HAZARD3_PACKAGES = verilator g++
BENCH_HAZARD3_SIMULATOR = $(abspath $(BENCH)/hazard3/Vtop)
# Verilator 5.006 drops words of the core's queue of instructions where it optimizes by itself.
BENCH_HAZARD3_VERILATE = verilator --cc --exe -O0 --x-assign fast -Wno-fatal -Wno-lint --top-module top --Mdir $(BENCH)/hazard3 \
	-y '$(HAZARD3)/hdl' -y '$(HAZARD3)/hdl/arith' '-I$(HAZARD3)/hdl' $(abspath tests/bench/hazard3/top.v tests/bench/hazard3/main.cpp)
BENCH_HAZARD3_ROWS = exact rect,exact albedo,exact span,exact cayley,exact rgb888,colour int8,colour span 16,albedo int8,palette,float folded,integer power,table power,

bench-hazard3: ## measure: cycles of the RP2350's RISC-V core, simulated from its Verilog, into costs.tsv: HAZARD3=FOLDER, a checkout of Wren6991/Hazard3
	@test -e '$(HAZARD3)/hdl/hazard3_core.v' || { echo "make: HAZARD3=$(HAZARD3): is no checkout of Hazard3: git clone https://github.com/Wren6991/Hazard3" >&2; exit 1; }
	@.ci/need "make bench-hazard3" $(BENCH_HAZARD3_PACKAGES) $(BENCH_PACKAGES) $(TARGETS_PACKAGES)
	@mkdir -p $(BENCH)/hazard3
	@$(BENCH_HAZARD3_VERILATE) >$(BENCH)/hazard3/log 2>&1 && \
		$(MAKE) -s -C $(BENCH)/hazard3 -f Vtop.mk OPT_FAST=-O3 OPT_GLOBAL=-O2 >>$(BENCH)/hazard3/log 2>&1 || { tail -5 $(BENCH)/hazard3/log >&2; exit 1; }
	@+$(SUBMAKE) write-hazard3

write-hazard3: $(BENCH_SCENE)/scene.json $(bare_image_rp2350) $(BENCH_MESH_INPUTS) $(BOARDS)
	@PYTHONDONTWRITEBYTECODE=1 BENCH_BOARDS=rp2350 COUNT_ROWS='$(BENCH_HAZARD3_ROWS)' COUNT_BY='hazard3=tests/bench/hazard3/run $(BENCH_HAZARD3_SIMULATOR)' \
		tests/targets/test_costs $(BENCH) simulated "$$(git -C '$(HAZARD3)' rev-parse --short=7 HEAD 2>/dev/null || echo unknown)"; worse=$$?; \
		tests/bench/tables write && exit $$worse

.PHONY: bench-hazard3 write-hazard3
