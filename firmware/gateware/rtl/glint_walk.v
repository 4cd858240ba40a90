// SPDX-License-Identifier: MIT
// From a span to its pixels: second-order differences and the reductions to Q16 (../README.md). A
// pixel a clock, spans back to back; a span of w = 0 is taken and gives none.
`default_nettype none

module glint_walk (
    input wire clk,
    input wire rst,
    input wire s_valid,
    output wire s_ready,
    input wire [31:0] s_t,
    input wire [31:0] s_dt,
    input wire [31:0] s_ddt,
    input wire [31:0] s_nl,
    input wire [31:0] s_dnl,
    input wire [12:0] s_w,
    output reg m_valid,
    input wire m_ready,
    output reg signed [17:0] m_c,
    output reg [16:0] m_nl,
    output reg m_last,
    output wire idle // no span and no pixel is inside
);
    reg busy; // t and nl are of a pixel that is to be given
    reg [31:0] t, dt, ddt, nl, dnl;
    reg [12:0] left; // pixels after it
    wire step = !m_valid | m_ready;
    wire last = left == 0;
    assign idle = !busy & !m_valid;
    assign s_ready = !busy | (step & last);

    always @(posedge clk) begin
        if (s_valid & s_ready) begin
            busy <= s_w != 0;
            t <= s_t;
            dt <= s_dt;
            ddt <= s_ddt;
            nl <= s_nl;
            dnl <= s_dnl;
            left <= s_w - 1;
        end else if (busy & step) begin
            busy <= !last;
            t <= t + dt;
            dt <= dt + ddt;
            nl <= nl + dnl;
            left <= left - 1;
        end
        if (rst) busy <= 0;
    end

    // 65536 - ((t + 2^13) >> 14). From t = 2^31 on it would not fit and is negative anyhow; from 0xf8000000 on t
    // counts as 0.
    wire signed [18:0] c = 19'sd65536 - $signed({1'b0, t[31:14]}) - $signed({18'b0, t[13]});
    // clamp((nl + 2^13) >> 14, 0, 65536)
    wire signed [18:0] n = $signed({nl[31], nl[31:14]}) + $signed({18'b0, nl[13]});
    always @(posedge clk) begin
        if (step) begin
            m_valid <= busy;
            m_c <= &t[31:27] ? 18'sd65536 : t[31] ? -18'sd1 : c[17:0];
            m_nl <= n[18] ? 17'd0 : n[17:16] != 0 ? 17'd65536 : {1'b0, n[15:0]};
            m_last <= last;
        end
        if (rst) m_valid <= 0;
    end

    wire unused = &{1'b0, c[18]}; // below t = 2^31 the two top bits are equal
endmodule

`default_nettype wire
