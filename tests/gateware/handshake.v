// SPDX-License-Identifier: MIT
// What the core's handshake promises, for yosys-smtbmc: any sequence of gaps, back-pressure and resets.
`default_nettype none

module handshake (
    input wire clk,
    input wire rst,
    input wire model,
    input wire [9:0] n,
    input wire [16:0] c_min,
    input wire s_valid,
    input wire [17:0] s_c,
    input wire m_ready
);
    localparam CLOCKS = 12;
    reg [4:0] sent, received;  // modulo 32, more than there is room for
    wire s_ready, m_valid;
    wire [16:0] m_f;
    wire [4:0] m_user;
    wire [CLOCKS:1] valid;
    wire [5*CLOCKS-1:0] history;
    wire [4:0] held;
    wire idle;
    glint_core dut (
        .clk(clk),
        .rst(rst),
        .model(model),
        .n(n),
        .c_min(c_min),
        .s_valid(s_valid),
        .s_ready(s_ready),
        .s_c(s_c),
        .s_user(sent),
        .m_valid(m_valid),
        .m_ready(m_ready),
        .m_f(m_f),
        .m_user(m_user),
        .idle(idle),
        .valid(valid), // these are exposed by test_handshake
        .\user.block.history (history),
        .\user.block.held (held)
    );

    reg started = 0, stalled = 0, was_reset = 0;
    reg [16:0] f;
    reg [4:0] user;
    // Pixels inside, and for each stage those before it: what the pixel there brought with it.
    integer i;
    reg [4:0] within;
    reg [4:0] ahead[1:CLOCKS];
    always @* begin
        within = 0;
        for (i = CLOCKS; i >= 1; i = i - 1) begin
            ahead[i] = within;
            within = within + {4'd0, valid[i]};
        end
    end
    always @(posedge clk) begin
        started <= 1;
        stalled <= m_valid && !m_ready && !rst;
        was_reset <= rst;
        f <= m_f;
        user <= m_user;
        if (rst) begin
            sent <= 0;
            received <= 0;
        end else begin
            sent <= sent + {4'd0, s_valid && s_ready};
            received <= received + {4'd0, m_valid && m_ready};
        end
    end

    always @* begin
        if (!started) assume (rst);
        if (started) begin
            // Nothing is lost or invented.
            assert (sent - received == within);
            // What has to wait stays as it is.
            if (stalled) assert (m_valid && m_f == f && m_user == user);
            // A reset empties.
            if (was_reset) assert (!m_valid && within == 0);
            // A pixel is taken whenever the last one can go.
            assert (s_ready == (!m_valid || m_ready));
            assert (idle == (sent == received));
            // Each comes with what went in with it: none overtakes. The lines before the last make the induction whole.
            for (i = 1; i <= CLOCKS; i = i + 1)
                if (valid[i]) begin
                    assert (held >= i);
                    assert (history[5*(i-1)+:5] == received + ahead[i]);
                end
            if (m_valid) assert (m_user == received);
        end
        cover (started && m_valid && within == CLOCKS);
    end
endmodule

`default_nettype wire
