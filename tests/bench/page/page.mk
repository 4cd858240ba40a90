# SPDX-License-Identifier: MIT
# make bench-page: milliseconds of a redraw by the page's module, beside the same functions natively, a part of make bench; and what a user
# waits for in a browser.
bench-page: ## measure: of make bench, the page's part alone: its redraws in node beside the same functions natively; and in Chromium
	@+$(SUBMAKE) setup-page
	@+$(SUBMAKE) run-bench-page
	@node tests/bench/page/browser.mjs $(PAGE_TEST_NPM) $(PAGE)

run-bench-page: $(PAGE)/index.html $(BENCH)/page/native
	@node tests/bench/page/page.mjs $(PAGE) $(BENCH)/page/native $(BENCH)/page.json

$(BENCH)/page/native: tests/bench/page/native.c $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	@$(CC) $(filter-out -MMD -MP,$(HOST_CFLAGS)) $^ -o $@ $(HOST_LDFLAGS) $(HOST_LDLIBS)

.PHONY: bench-page run-bench-page
