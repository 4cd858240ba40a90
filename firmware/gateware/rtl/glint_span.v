// SPDX-License-Identifier: MIT
// The span unit: one prepared span in (struct glint_span), its pixels out in RGB565, those of glint_shade_span_c16 for a
// material with albedo 255 in gamma space, undithered. A pixel a clock, the first 19 clocks later; spans follow each
// other without a gap.
module glint_span #(
    parameter WHITE = 0, // 1: the specular coefficient of red is that of all; two products less
    parameter ROWS = 1 // 1: those two are made of logic cells, not of multiplier blocks
) (
    input clk,
    input rst,
    // Registers, held still while pixels are inside.
    input model,        // 0: MSH, 1: Schlick
    input [9:0] n,      // 1..1000
    input [16:0] c_min, // glint_cutoff(model, n, q)
    input clamp_peak,
    input [50:0] ambient, // {red, green, blue}, 17 bits each, 0..65536 = 1.0
    input [50:0] diffuse,
    input [50:0] specular,
    // Spans.
    input s_valid,
    output s_ready,
    input [31:0] s_t,
    input [31:0] s_dt,
    input [31:0] s_ddt,
    input [31:0] s_nl,
    input [31:0] s_dnl,
    input [12:0] s_w, // 0..4096
    // Pixels.
    output m_valid,
    input m_ready,
    output [15:0] m_rgb565,
    output m_last // of its span
);
    wire walk_valid, walk_ready, walk_last;
    wire signed [17:0] c;
    wire [16:0] nl;
    glint_walk walk (
        .clk(clk), .rst(rst), .s_valid(s_valid), .s_ready(s_ready), .s_t(s_t), .s_dt(s_dt), .s_ddt(s_ddt), .s_nl(s_nl),
        .s_dnl(s_dnl), .s_w(s_w), .m_valid(walk_valid), .m_ready(walk_ready), .m_c(c), .m_nl(nl), .m_last(walk_last)
    );

    wire core_valid, core_ready, core_last;
    wire [16:0] f, core_nl;
    glint_core #(.USER(18)) core (
        .clk(clk), .rst(rst), .model(model), .n(n), .c_min(c_min), .s_valid(walk_valid), .s_ready(walk_ready), .s_c(c),
        .s_user({walk_last, nl}), .m_valid(core_valid), .m_ready(core_ready), .m_f(f), .m_user({core_last, core_nl})
    );

    glint_shade #(.WHITE(WHITE), .ROWS(ROWS)) shade (
        .clk(clk), .rst(rst), .clamp_peak(clamp_peak), .ambient(ambient), .diffuse(diffuse), .specular(specular),
        .s_valid(core_valid), .s_ready(core_ready), .s_f(f), .s_nl(core_nl), .s_last(core_last),
        .m_valid(m_valid), .m_ready(m_ready), .m_rgb565(m_rgb565), .m_last(m_last)
    );
endmodule
