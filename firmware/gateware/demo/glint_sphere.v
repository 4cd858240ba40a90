// SPDX-License-Identifier: MIT
// The spans of a row of the demo's sphere (sphere.h), lit by a light that may move: exactly those of glint_span_init
// between the normals of a span's first pixel and of the pixel after its last, with no multiplier. x and y advance by
// additions; z is a square root, bit by bit, and each of its bits at once adds to N.H, N.L and z z' with the z
// before. 17 clocks a span.
`default_nettype none

module glint_sphere (
    input wire clk,
    input wire rst,
    input wire start, // while not busy
    input wire [8:0] row, // of 480; the sphere is in 41..439
    input wire [159:0] light, // glint_orbit's; held still while busy
    output wire busy,
    output wire [7:0] half_width, // of the row, from the fourth clock after start
    output wire m_valid,
    input wire m_ready,
    output wire [31:0] m_t,
    output wire [31:0] m_dt,
    output wire [31:0] m_ddt,
    output wire [31:0] m_nl,
    output wire [31:0] m_dnl,
    output wire [12:0] m_w
);
    wire [23:0] lx_164 = light[159:136], ly_164 = light[135:112], hx_164 = light[95:72], hy_164 = light[71:48];
    wire [15:0] lz = light[111:96], hz = light[47:32];
    wire [31:0] one_hh = light[31:0];

    reg [7:0] distance; // |j|
    reg under; // j < 0
    wire [51:0] chord;
    glint_chord chords (.clk(clk), .row(distance), .chord(chord));
    assign half_width = chord[51:44];

    localparam IDLE = 3'd0, FETCH = 3'd1, ROW = 3'd2, RUN = 3'd3, DONE = 3'd4;
    localparam X = 2'd0, Y = 2'd1, Z = 2'd2;
    reg [2:0] state;
    reg [1:0] axis; // of what RUN multiplies
    reg [3:0] count;

    // ---- RUN: 15 bits, first the highest, of |i|, |j| or z; a clock later each bit is added in ----
    reg [14:0] magnitude;
    reg [29:0] radicand; // what is left of it
    reg [16:0] remainder;
    reg [14:0] root, root_before;
    wire [18:0] trial = {remainder, radicand[29:28]} - {2'b0, root, 2'b01};
    reg bit_now;
    wire [23:0] h = axis == X ? hx_164 : axis == Y ? hy_164 : {{8{hz[15]}}, hz};
    wire [23:0] l = axis == X ? lx_164 : axis == Y ? ly_164 : {{8{lz[15]}}, lz};
    reg [31:0] sum_h, sum_l;
    reg [29:0] sum_z;
    always @(posedge clk)
        if (state == RUN) begin
            bit_now <= axis == Z ? !trial[18] : magnitude[14];
            sum_h <= {sum_h[30:0], 1'b0} + ({32{bit_now}} & {{8{h[23]}}, h});
            sum_l <= {sum_l[30:0], 1'b0} + ({32{bit_now}} & {{8{l[23]}}, l});
            sum_z <= {sum_z[28:0], 1'b0} + ({30{bit_now}} & {15'b0, root_before});
            if (count == 0) begin
                sum_h <= 0;
                sum_l <= 0;
                sum_z <= 0;
            end
        end

    // ---- where the row is: this normal's z^2, i, and the part of N.H and N.L that x and y give ----
    reg [29:0] z2;
    reg [21:0] i_3362; // twice 41^2 i
    reg [31:0] flat_h, flat_l;
    reg [8:0] done, left; // pixels
    reg long, long_next; // the span that ends here, that begins here: 16 pixels, else 2
    reg first;
    // x = 164 i: x'^2 - x^2 = 16 m (41^2 (2 i + m))
    wire [21:0] half_step = long_next ? 22'd26896 : 22'd3362;
    reg [21:0] middle;
    reg [29:0] z2_next;
    always @(posedge clk) begin // in RUN, which gives them the time
        middle <= i_3362 + half_step;
        z2_next <= z2 - (long_next ? {middle, 8'b0} : {{3{middle[21]}}, middle, 5'b0});
    end
    wire [4:0] length_next = long_next ? 5'd16 : 5'd2;
    wire [31:0] step_h = long_next ? {{4{hx_164[23]}}, hx_164, 4'b0} : {{7{hx_164[23]}}, hx_164, 1'b0};
    wire [31:0] step_l = long_next ? {{4{lx_164[23]}}, lx_164, 4'b0} : {{7{lx_164[23]}}, lx_164, 1'b0};
    wire minus = axis == X | (axis == Y & under);

    wire worker_idle;
    wire hand = state == DONE & axis == Z & worker_idle;
    always @(posedge clk) begin
        case (state)
            IDLE:
                if (start) begin
                    under <= row >= 240;
                    distance <= row >= 240 ? row[7:0] - 8'd240 : 8'd240 - row[7:0];
                    count <= 0;
                    state <= FETCH;
                end
            FETCH: begin // the memory has read when count is 1
                count <= count + 1;
                if (count == 1) state <= ROW;
            end
            ROW: begin
                z2 <= {6'b0, chord[43:20]};
                i_3362 <= -{2'b0, chord[19:0]};
                magnitude <= {7'b0, half_width};
                flat_h <= 0;
                flat_l <= 0;
                done <= 0;
                left <= {half_width, 1'b0};
                first <= 1;
                axis <= X;
                count <= 0;
                state <= RUN;
            end
            RUN: begin
                count <= count + 1;
                magnitude <= {magnitude[13:0], 1'b0};
                if (count != 15) begin
                    radicand <= {radicand[27:0], 2'b0};
                    remainder <= trial[18] ? {remainder[14:0], radicand[29:28]} : trial[16:0];
                    root <= {root[13:0], !trial[18]};
                end
                long_next <= done >= 8 && left >= 24; // short where the sphere turns away
                if (count == 15) state <= DONE;
            end
            default: begin // DONE
                if (axis != Z | worker_idle) begin
                    flat_h <= flat_h + ((axis == Z ? step_h : sum_h) ^ {32{minus}}) + {31'b0, minus};
                    flat_l <= flat_l + ((axis == Z ? step_l : sum_l) ^ {32{minus}}) + {31'b0, minus};
                    radicand <= axis == Z ? z2_next : z2;
                    remainder <= 0;
                    root <= 0;
                    magnitude <= {7'b0, distance};
                    axis <= axis == X ? Y : Z;
                    state <= axis == Z && left == 0 ? IDLE : RUN;
                end
                if (hand) begin
                    root_before <= root;
                    first <= 0;
                    long <= long_next;
                    done <= done + {4'b0, length_next};
                    left <= left - {4'b0, length_next};
                    i_3362 <= middle + half_step;
                    z2 <= z2_next;
                end
            end
        endcase
        if (rst) state <= IDLE;
    end

    // ---- the worker: from this normal and the one before to a span, while RUN finds the next ----
    localparam OFFER = 3'd6;
    reg [2:0] work; // 0: idle
    reg opening, closing, wide;
    reg [31:0] base, dot_h, dot_l, zz, zz_before, zz_sum, t, t_before, nl_before, change, lead;
    reg [29:0] dot_z;
    reg signed [33:0] rise, rise_led, rise_rounded;
    reg signed [32:0] turn, turn_rounded;
    wire [31:0] twice_base = one_hh - {15'b0, remainder};
    wire [31:0] ddt = wide ? {8'b0, change[31:8]} : {2'b0, change[31:2]};
    assign worker_idle = work == 0;
    always @(posedge clk) begin
        if (hand) begin
            base <= {1'b0, twice_base[31:1]}; // (|N|^2 + |H|^2) / 2
            dot_h <= flat_h + sum_h;
            dot_l <= flat_l + sum_l;
            dot_z <= sum_z;
            zz <= {2'b0, z2} - {15'b0, remainder};
            opening <= first;
            closing <= left == 0;
            wide <= long;
            work <= 1;
        end else if (work == OFFER ? m_ready : work != 0)
            work <= work == OFFER || (work == 2 && opening) ? 3'd0 : work + 3'd1;
        case (work)
            1: begin
                t <= base - dot_h; // |N - H|^2 / 2
                zz_sum <= zz + zz_before;
                // for the next: with (164 m)^2, and m^2 / 2 to round by
                zz_before <= zz + (long ? 32'd6885504 : 32'd107586);
            end
            2: begin
                change <= zz_sum - {1'b0, dot_z, 1'b0}; // |N' - N|^2
                rise <= $signed({2'b0, t}) - $signed({2'b0, t_before});
                turn <= $signed({dot_l[31], dot_l}) - $signed({nl_before[31], nl_before});
            end
            3: lead <= wide ? {ddt[24:0], 7'b0} - {ddt[28:0], 3'b0} : ddt; // ddt m (m - 1) / 2
            4: begin
                rise_led <= rise - $signed({2'b0, lead});
                // halves away from 0
                turn_rounded <= turn + $signed({29'b0, wide ? 4'd8 - {3'b0, turn[32]} : {3'b0, !turn[32]}});
            end
            5: rise_rounded <= rise_led + $signed({30'b0, wide ? 4'd8 - {3'b0, rise_led[33]} : {3'b0, !rise_led[33]}});
            default: ;
        endcase
        if (work == 2 ? opening : work == OFFER & m_ready) begin
            t_before <= t;
            nl_before <= dot_l;
        end
        if (rst) work <= 0;
    end

    assign busy = state != IDLE | work != 0;
    assign m_valid = work == OFFER;
    assign m_t = t_before;
    assign m_dt = wide ? {{2{rise_rounded[33]}}, rise_rounded[33:4]} : rise_rounded[32:1];
    assign m_ddt = ddt;
    assign m_nl = nl_before;
    assign m_dnl = wide ? {{3{turn_rounded[32]}}, turn_rounded[32:4]} : turn_rounded[32:1];
    assign m_w = (wide ? 13'd16 : 13'd2) + {12'b0, closing};
    wire unused = &{1'b0, trial[17], twice_base[0], rise_rounded[0], turn_rounded[0], change[1:0]};
endmodule

`default_nettype wire
