// SPDX-License-Identifier: MIT
// Plays +vectors=FILE (vectors.c) to a netlist of glint_core with gaps and back-pressure, and says how many pixels
// were wrong.
`default_nettype none

`timescale 1ns / 1ps
module netlist_tb;
    reg clk = 0, rst = 1, model = 0, s_valid = 0, m_ready = 0;
    reg [9:0] n = 1;
    reg [16:0] c_min = 0;
    reg signed [17:0] s_c = 0;
    reg [3:0] s_user = 0;
    wire s_ready, m_valid;
    wire [16:0] m_f;
    wire [3:0] m_user;
    glint_core dut (
        .clk(clk),
        .rst(rst),
        .model(model),
        .n(n),
        .c_min(c_min),
        .s_valid(s_valid),
        .s_ready(s_ready),
        .s_c(s_c),
        .s_user(s_user),
        .m_valid(m_valid),
        .m_ready(m_ready),
        .m_f(m_f),
        .m_user(m_user)
    );

    reg [8*256-1:0] name;
    integer file, found, line_model, line_n, line_c_min, line_c, line_f;
    integer sent = 0, received = 0, wrong = 0, clocks = 0;
    reg [16:0] expected[0:63];
    reg more = 1;
    wire same = line_model[0] == model && line_n[9:0] == n && line_c_min[16:0] == c_min;

    task next_line;
        begin
            found = $fscanf(file, "%d %d %d %d %d", line_model, line_n, line_c_min, line_c, line_f);
            more = found == 5;
        end
    endtask

    always #5 clk = ~clk;

    // Inputs change between edges; what the rising edge sees is counted at it.
    initial begin
        if (!$value$plusargs("vectors=%s", name)) $finish;
        file = $fopen(name, "r");
        next_line;
        repeat (4) @(negedge clk);
        rst = 0;
        while (more || received != sent) begin
            @(negedge clk);
            clocks = clocks + 1;
            if (clocks > 20 * (sent + 100)) begin
                $display("%0d pixels of %0d, then nothing", received, sent);
                $finish;
            end
            if (!s_valid && more && !same && received == sent) begin
                model = line_model[0];
                n = line_n[9:0];
                c_min = line_c_min[16:0];
                @(negedge clk);
            end
            if (!s_valid && more && same && $random % 8 != 0) begin
                s_valid = 1;
                s_c = line_c[17:0];
                s_user = sent[3:0];
            end
            m_ready = $random % 8 != 0;
            #4;
            if (m_valid !== 0 && m_ready) begin
                if (received == sent || m_valid !== 1 || m_f !== expected[received%64] || m_user !== received[3:0])
                    wrong = wrong + 1;
                received = received + 1;
            end
            if (s_valid && s_ready === 1) begin
                expected[sent%64] = line_f[16:0];
                sent = sent + 1;
                next_line;
                @(posedge clk);
                #1 s_valid = 0;
            end
            if (wrong > 100) more = 0;
            if (wrong > 200) received = sent;
        end
        $display("%0d pixels, %0d wrong", received, wrong);
        $finish;
    end
endmodule

`default_nettype wire
