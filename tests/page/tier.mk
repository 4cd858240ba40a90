# SPDX-License-Identifier: MIT
# Tier page: the page's module in node, against the command.
setup-page: setup-build setup-page-build

test-page: ## check: the page: its module, pictures and files against the command
	@+tests/tier page "$(SUBMAKE)"

run-page: all $(PAGE)/index.html
	@TALLY_JOBS=$$(nproc) tests/tally "node tests/page/test_module.mjs $(PAGE) $(abspath $(BUILD)/glint)"

.PHONY: setup-page test-page run-page
