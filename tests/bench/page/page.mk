# SPDX-License-Identifier: MIT
# make bench-page: milliseconds of a redraw by the page's module, beside the same functions natively. A part of make bench.
bench-page: ## measure: of make bench, the page's part alone: its redraws in node beside the same functions natively
	@+$(SUBMAKE) setup-build setup-page-build
	@+$(SUBMAKE) run-bench-page

run-bench-page: $(PAGE)/index.html $(BENCH)/page/native
	@node tests/bench/page/page.mjs $(PAGE) $(BENCH)/page/native $(BENCH)/page.json

$(BENCH)/page/native: tests/bench/page/native.c $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	@$(CC) $(filter-out -MMD -MP,$(HOST_CFLAGS)) $^ -o $@ $(HOST_LDFLAGS) $(HOST_LDLIBS)

.PHONY: bench-page run-bench-page
