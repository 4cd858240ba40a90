# SPDX-License-Identifier: MIT
# Tier gateware: the Verilog against the library. tests/gateware/test_NAME.cpp is linked with Verilator's model of module
# glint_NAME (of rtl or demo) and with the library; every other tests/gateware/test_* is a script that speaks TAP. Both run with
# GATEWARE_BUILD, a folder of their own to write to, in the environment.
GATEWARE_TEST_PACKAGES = gcc g++ libc6-dev make libpng-dev verilator iverilog z3 python3-yaml
GATEWARE_CHECK = verilator:verilator
GATEWARE_TESTS = $(patsubst tests/gateware/test_%.cpp,$(BUILD)/tests/gateware/test_%,$(wildcard tests/gateware/test_*.cpp))
# The longest first.
GATEWARE_LONG = $(addprefix tests/gateware/test_,faults handshake span_faults flat netlist netlist_xilinx)
GATEWARE_SCRIPTS = $(filter-out %.cpp %.v,$(wildcard tests/gateware/test_*))
# Their parameters, and what one is linked with.
GATEWARE_PARAMETERS_core = -GUSER=16
GATEWARE_PARAMETERS_lite = -GUSER=16
GATEWARE_PARAMETERS_span_wb = -GSKID=1
GATEWARE_LDLIBS_demo = -lpng
# The registers' header as C.
GATEWARE_OBJECTS_span_wb = $(BUILD)/tests/gateware/unit_registers.o
GATEWARE_VERILATE = verilator --cc --exe --build -Wall -Wno-fatal -O3 --x-assign unique $(GATEWARE_PARAMETERS_$*) \
	-CFLAGS "-O3 $(patsubst %,-I$(CURDIR)/%,lib tests/gateware firmware/core firmware/gateware/demo firmware/gateware/registers)" \
	$(GATEWARE_LDLIBS_$*:%=-LDFLAGS %) -Ifirmware/gateware/rtl -Ifirmware/gateware/demo
GATEWARE_LIBRARY = $(BUILD)/tests/gateware/libglint.a
GATEWARE_ENV = GATEWARE_BUILD=$(CURDIR)/$(GATEWARE)/test VECTORS=$(CURDIR)/$(BUILD)/tests/gateware/vectors \
	LIBGLINT=$(CURDIR)/$(GATEWARE_LIBRARY) ORBIT=$(CURDIR)/$(BUILD)/firmware/core/orbit.o TABLES=$(CURDIR)/$(GATEWARE_TABLES)

# The library at -O3: the tests wait for it more than for the model.
$(GATEWARE_LIBRARY): $(wildcard lib/*.[ch])
	@+$(SUBMAKE) -s BUILD=build/o3 CFLAGS=-O3 build/o3/libglint.a
	@mkdir -p $(@D) && cp build/o3/libglint.a $@

$(BUILD)/tests/gateware/test_%: tests/gateware/test_%.cpp $(GATEWARE_RTL) $(GATEWARE_DEMO) $(wildcard tests/gateware/*.h firmware/gateware/*/*.h) \
		$(GATEWARE_LIBRARY) $(BUILD)/firmware/core/orbit.o $(BUILD)/tests/gateware/unit_registers.o
	@mkdir -p $@.dir
	@$(GATEWARE_VERILATE) --top-module glint_$* --prefix Vtop --Mdir $@.dir -o ../$(@F) $(CURDIR)/$< $(CURDIR)/$(BUILD)/firmware/core/orbit.o \
		$(addprefix $(CURDIR)/,$(GATEWARE_OBJECTS_$*) $(GATEWARE_LIBRARY)) $(wildcard firmware/gateware/*/glint_$*.v) >$@.log 2>&1 || { cat $@.log >&2; exit 1; }

$(BUILD)/tests/gateware/unit_registers.o: tests/gateware/unit_registers.c $(wildcard tests/gateware/*.h firmware/gateware/registers/*.h)
	@mkdir -p $(@D)
	@$(CC) -Ilib -Ifirmware/gateware/registers $(LIB_CFLAGS) -c $< -o $@

setup-gateware: setup-gateware-tools
	@.ci/need "tier gateware (simulators, solvers)" $(GATEWARE_TEST_PACKAGES)

test-gateware: ## check: the Verilog: every cosine and shininess against the library, the netlist, the handshake proved, faults found
	@+tests/tier gateware "$(SUBMAKE)"

# What the netlist's test plays.
$(BUILD)/tests/gateware/vectors: tests/gateware/vectors.c $(GATEWARE_LIBRARY)
	@$(CC) -std=c11 $(WARNINGS) -O2 -Ilib $^ -o $@

run-gateware: $(GATEWARE_TESTS) $(BUILD)/tests/gateware/vectors $(GATEWARE_TABLES)
	@mkdir -p $(GATEWARE)/test
	@$(GATEWARE_ENV) tests/tally $(GATEWARE_LONG) $(filter-out $(GATEWARE_LONG),$(GATEWARE_SCRIPTS)) $(GATEWARE_TESTS)

# The quick part: lint, with what is installed.
check-gateware:
	@if tests/missing "$(CC)" "" "" $(GATEWARE_CHECK) >/dev/null; then tests/tally tests/gateware/test_lint; \
	else tests/tally "echo ok 1 - tier gateware # SKIP verilator is not installed: make setup-gateware"; fi

.PHONY: setup-gateware test-gateware run-gateware check-gateware
