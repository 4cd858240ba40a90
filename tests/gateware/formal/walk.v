// SPDX-License-Identifier: MIT
// The walk under any spans and any taking: what it offers is held; with COUNT: a span of w gives w pixels, the last
// marked.
`default_nettype none

module walk (
    input wire clk,
    input wire rst,
    input wire s_valid,
    input wire [31:0] s_t,
    input wire [31:0] s_dt,
    input wire [31:0] s_ddt,
    input wire [31:0] s_nl,
    input wire [31:0] s_dnl,
    input wire [12:0] s_w,
    input wire m_ready
);
    wire s_ready, m_valid, m_last;
    wire signed [17:0] m_c;
    wire [16:0] m_nl;
    glint_walk dut (
        .clk(clk),
        .rst(rst),
        .s_valid(s_valid),
        .s_ready(s_ready),
        .s_t(s_t),
        .s_dt(s_dt),
        .s_ddt(s_ddt),
        .s_nl(s_nl),
        .s_dnl(s_dnl),
        .s_w(s_w),
        .m_valid(m_valid),
        .m_ready(m_ready),
        .m_c(m_c),
        .m_nl(m_nl),
        .m_last(m_last)
    );
    held #(.WIDTH(36)) offered (.clk(clk), .rst(rst), .valid(m_valid), .ready(m_ready), .data({m_c, m_nl, m_last}));

`ifdef COUNT
    // Of spans taken but for w = 0: pixels due, and lasts due.
    reg [15:0] pixels, lasts;
    reg begun = 0, quiet;
    wire in = s_valid & s_ready & s_w != 0, out = m_valid & m_ready;
    always @(posedge clk) begin
        assume (s_w <= 2);
        pixels <= rst ? 0 : pixels + (in ? s_w : 0) - out;
        lasts <= rst ? 0 : lasts + in - (out & m_last);
        if (!rst & out) assert (pixels != 0 && (lasts > 1 || (pixels == 1) == m_last));
        // Where nothing is offered for two clocks though spans would be taken, nothing is due.
        quiet <= !rst & s_ready & !s_valid & !m_valid;
        if (begun & !rst & quiet & !m_valid) assert (pixels == 0 && lasts == 0);
        begun <= 1;
    end
`endif
endmodule

`default_nettype wire
