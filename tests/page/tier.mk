# SPDX-License-Identifier: MIT
# Tier page: the page's module in node, and the page in Debian's browsers, against the command.
PAGE_TEST_PACKAGES = chromium firefox-esr
PAGE_TEST_NPM = $(PAGE)/tests/npm
PAGE_CONFORMANCE = $(PAGE)/tests/conformance.wasm
# Random states, each compared with the command's picture; one takes Firefox 140 .4 s of a processor, Firefox 153 and Chromium .05.
PAGE_STATES_chromium = 940
PAGE_STATES_firefox = 60

setup-page: setup-build setup-page-build
	@.ci/need "tier page (browsers)" $(PAGE_TEST_PACKAGES)
	@+$(SUBMAKE) -s $(PAGE_TEST_NPM)/done

$(PAGE_TEST_NPM)/done: tests/page/package.json tests/page/package-lock.json
	@rm -rf $(@D) && mkdir -p $(@D) && cp $^ $(@D)
	@npm ci --prefix $(@D) --ignore-scripts --no-audit --no-fund --loglevel=error >$(PAGE)/tests/npm.log 2>&1 || \
		{ tail -5 $(PAGE)/tests/npm.log >&2; echo "make: npm could not install what tier page needs" >&2; exit 1; }
	@touch $@

test-page: ## check: the page in Chromium and Firefox: pictures, files, messages, against the command
	@+tests/tier page "$(SUBMAKE)"

run-page: all $(PAGE)/index.html $(PAGE_CONFORMANCE) $(CONFORMANCE_EXPECTED)
	@tests/tally $(foreach browser,firefox chromium,$(foreach test,controls screens files,"node tests/page/test_$(test).mjs $(PAGE_TEST_NPM) $(PAGE) $(abspath $(BUILD)/glint) $(browser)")) \
		$(foreach browser,chromium firefox,"node tests/page/test_browser.mjs \
		$(PAGE_TEST_NPM) $(PAGE) $(abspath $(BUILD)/glint) $(browser) $(PAGE_STATES_$(browser))") \
		"node tests/page/test_device.mjs $(PAGE_TEST_NPM) $(PAGE) $(abspath $(BUILD)/glint)" \
		"node tests/page/test_module.mjs $(PAGE) $(abspath $(BUILD)/glint)" \
		"node tests/page/test_hostile.mjs $(PAGE)" \
		"node tests/page/test_conformance.mjs $(PAGE_CONFORMANCE) $(CONFORMANCE_EXPECTED)"

# The checks that boards run, over the module's own objects of the library.
$(PAGE_CONFORMANCE): $(CONFORMANCE_INPUTS) firmware/conformance/expected.c $(filter $(PAGE)/objects/lib/%,$(PAGE_OBJECTS))
	@mkdir -p $(@D)
	@clang $(filter-out -MMD -MP,$(PAGE_CFLAGS)) -Ifirmware/conformance -Ifirmware/ports/bare $(filter %.c %.o,$^) \
		-Wl,--stack-first,-z,stack-size=1048576 -o $@

# The READMEs' picture of the page.
page-picture: setup-page $(PAGE)/index.html ## maintain: host/page/page.png, the page as READMEs show it
	@node tests/page/picture.mjs $(PAGE_TEST_NPM) $(PAGE) host/page/page.png

.PHONY: setup-page test-page run-page page-picture
