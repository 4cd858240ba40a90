// SPDX-License-Identifier: MIT
// The walk under any spans and any taking, for ever: each span's pixels come out, in order, by the recurrences and
// reductions of the unit's sequence, the last one marked; what is offered stays; idle says that nothing is inside.
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
    wire s_ready, m_valid, m_last, idle, busy;
    wire signed [17:0] m_c;
    wire [16:0] m_nl;
    wire [31:0] t, dt, ddt, nl, dnl;
    wire [12:0] left;
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
        .m_last(m_last),
        .idle(idle),
        .busy(busy), // these are exposed by test_span_handshake
        .t(t),
        .dt(dt),
        .ddt(ddt),
        .nl(nl),
        .dnl(dnl),
        .left(left)
    );
    held #(
        .WIDTH(36)
    ) offered (
        .clk(clk),
        .rst(rst),
        .valid(m_valid),
        .ready(m_ready),
        .data({m_c, m_nl, m_last})
    );

    // The model: pixels due, what the next is made of, and what is offered. It knows the ports alone.
    reg [12:0] due;
    reg [31:0] next_t, next_dt, next_ddt, next_nl, next_dnl;
    reg offers, offered_last;
    reg signed [17:0] offered_c;
    reg [16:0] offered_nl;
    wire room = !offers | m_ready;
    // 65536 - ((t + 2^13) >> 14), where t from 0xf8000000 on is 0 (it was less before it wrapped), and -1 for all
    // below 0 that 18 bits would not hold.
    wire [32:0] t_or_0 = next_t >= 32'hf8000000 ? 33'd0 : {1'b0, next_t};
    wire [32:0] t_q16 = (t_or_0 + 33'd8192) >> 14;
    wire signed [33:0] c = 34'sd65536 - $signed({1'b0, t_q16});
    wire signed [33:0] nl_q16 = ($signed({{2{next_nl[31]}}, next_nl}) + 34'sd8192) >>> 14;
    reg begun = 0;
    always @(posedge clk) begin
        begun <= 1;
        if (room) begin
            offers <= due != 0;
            offered_c <= t_or_0[31] ? -18'sd1 : c[17:0];
            offered_nl <= nl_q16 < 0 ? 17'd0 : nl_q16 > 65536 ? 17'd65536 : nl_q16[16:0];
            offered_last <= due == 1;
        end
        if (s_valid & s_ready) begin
            due <= s_w;
            next_t <= s_t;
            next_dt <= s_dt;
            next_ddt <= s_ddt;
            next_nl <= s_nl;
            next_dnl <= s_dnl;
        end else if (room & due != 0) begin
            due <= due - 1;
            next_t <= next_t + next_dt;
            next_dt <= next_dt + next_ddt;
            next_nl <= next_nl + next_dnl;
        end
        if (rst) begin
            due <= 0;
            offers <= 0;
        end
        if (begun) begin
            // A span is taken when the last pixel of the one before goes, and no sooner.
            assert (s_ready == (due == 0 || (room && due == 1)));
            assert (m_valid == offers);
            if (offers) assert (m_c == offered_c && m_nl == offered_nl && m_last == offered_last);
            assert (idle == (due == 0 && !offers));
            // So that the induction is whole:
            assert (busy == (due != 0));
            if (busy) begin
                assert (left == due - 13'd1 && t == next_t && dt == next_dt && ddt == next_ddt);
                assert (nl == next_nl && dnl == next_dnl);
            end
        end
    end
endmodule

`default_nettype wire
