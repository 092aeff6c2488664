# A random street scene for vdamf-simulate, to train the vehicle discriminator on:
#   awk -v seed=1 -v sensor=HDL-32E [-v green=1] [-v built=1] -f scripts/random-scene.awk > scene.ini
# With green=1 what grows together stands together: trunks in hedges, cars under trees, walls with
# corners, people in groups. Else all stands alone. With built=1 fronts of houses line the street:
# piers with windows, recesses of doors and passages between them, rooms behind.
# Vehicles of any size between clutter of any size, in rows along the road. The numbers are from a
# generator of its own, so that every awk makes the same scene of a seed.

function random()
{
    state = (state * 16807) % 2147483647
    return state / 2147483647
}
function between(low, high) { return low + (high - low) * random() }
function oneOf(words,    list, n)
{
    n = split(words, list, " ")
    return list[1 + int(n * random())]
}

# Object of a class and size at a place; a speed of 0 is not written.
function object(class, length_m, width_m, height_m, x, y, heading, speed)
{
    printf "\n[object %s_%d]\nclass = %s\n", class, ++objects, class
    printf "length_m = %.2f\nwidth_m = %.2f\nheight_m = %.2f\n", length_m, width_m, height_m
    printf "x_m = %.2f\ny_m = %.2f\nheading_deg = %.1f\n", x, y, heading
    if (speed != 0) printf "speed_mps = %.2f\n", speed
}

function setSize(l, w, h) { sizeL = l; sizeW = w; sizeH = h }

# A class of vehicle; its size in sizeL, sizeW, sizeH.
function vehicle(    class, k)
{
    class = oneOf("car car car hatchback hatchback hatchback suv suv suv van van truck bus")
    if (class == "car") setSize(between(4.0, 5.2), between(1.68, 1.95), between(1.36, 1.56))
    if (class == "hatchback") setSize(between(2.8, 4.5), between(1.55, 1.85), between(1.38, 1.62))
    if (class == "suv") setSize(between(4.0, 5.3), between(1.75, 2.05), between(1.6, 1.95))
    if (class == "van") setSize(between(4.3, 7.0), between(1.8, 2.15), between(1.8, 2.8))
    if (class == "truck") setSize(between(5.5, 12), between(2.1, 2.55), between(2.4, 4.0))
    if (class == "bus") setSize(between(8, 15), between(2.4, 2.55), between(2.8, 3.6))
    return class
}

# A class of clutter; its size in sizeL, sizeW, sizeH.
function clutter(    class)
{
    class = oneOf("bush bush bush bush bush tree tree pole pole sign wall wall guard_rail box box " \
                  "pedestrian pedestrian bicycle motorcycle")
    if (class == "bush") setSize(between(0.7, 7), between(0.7, 3), between(0.6, 3))
    if (class == "tree") setSize(between(2, 6), between(2, 6), between(4, 9))
    if (class == "pole") setSize(between(0.08, 0.5), between(0.08, 0.5), between(1, 6))
    if (class == "sign") setSize(0.1, between(0.4, 1.3), between(1.5, 3.5))
    if (class == "wall") setSize(between(1.5, 22), between(0.15, 0.5), between(0.6, 4))
    if (class == "guard_rail") setSize(between(4, 24), 0.3, between(0.6, 0.9))
    if (class == "box") setSize(between(0.4, 1.9), between(0.4, 1.3), between(0.5, 2.1))
    if (class == "pedestrian") setSize(between(0.4, 0.7), between(0.4, 0.7), between(1.1, 1.95))
    if (class == "bicycle") setSize(between(1.5, 1.9), between(0.4, 0.7), between(0.9, 1.9))
    if (class == "motorcycle") setSize(between(1.9, 2.4), between(0.6, 0.9), between(1.1, 1.7))
    return class
}

# What drives in a lane, without catching up: all at one speed.
function lane(y, heading, speed,    x, class)
{
    for (x = between(-45, -10); x < 110; x += sizeL / 2 + between(8, 40))
    {
        class = random() < 0.85 ? vehicle() : oneOf("bicycle motorcycle")
        if (class == "bicycle") setSize(1.8, 0.6, between(1.6, 1.85))
        if (class == "motorcycle") setSize(2.2, 0.8, between(1.4, 1.7))
        x += sizeL / 2
        if (y < 0 && x > -14 && x < 14) continue  # the platform
        object(class, sizeL, sizeW, sizeH, x, y + between(-0.3, 0.3), heading, speed)
    }
}

# Clutter of several parts in a row along the road, from x on. Returns where it ends.
function group(x, y,    kind, l, h, n)
{
    kind = oneOf("hedge hedge hedge corner people shelter parked parked")
    l = between(2, 9)
    if (kind == "hedge")
    {
        h = between(0.3, 1.5)
        object("bush", l, between(0.6, 2.5), h, x + l / 2, y, between(-6, 6), 0)
        for (n = 0; n < 1 + 2 * random(); ++n)
            object("pole", 0.3, 0.3, between(2.5, 6), x + l * random(), y, 0, 0)
        if (random() < 0.5) object("bush", between(1, 3), 1.2, h + between(0, 1), x, y, 0, 0)
    }
    if (kind == "corner")
    {
        h = between(0.8, 3.5)
        object("wall", l, 0.25, h, x + l / 2, y, 0, 0)
        object("wall", between(1, 5), 0.25, h, x + l * random(), y, 90 + between(-5, 5), 0)
    }
    if (kind == "people")
    {
        l = 2.5
        for (n = 0; n < 2 + 4 * random(); ++n)
            object("pedestrian", 0.5, 0.5, between(1.1, 1.95), x + l * random(),
                   y + between(-0.9, 0.9), between(0, 360), 0)
    }
    if (kind == "shelter")
    {
        l = between(3, 5)
        object("wall", l, 0.1, 2.4, x + l / 2, y + (y < 0 ? -0.7 : 0.7), 0, 0)
        object("wall", 1.4, 0.1, 2.4, x, y, 90, 0)
        object("box", between(1, 2), 0.5, 0.5, x + l / 2, y, 0, 0)
    }
    if (kind == "parked")
    {
        object(vehicle(), sizeL, sizeW, sizeH, x + sizeL / 2, y, between(-4, 4), 0)
        l = sizeL
        object("tree", between(3, 5), between(3, 5), between(5, 8), x + l * random(),
               y + (y < 0 ? -1 : 1) * between(1.3, 2), 0, 0)
    }
    return x + l
}

# Posts in a line, bare or with rails: bollards, fences. Returns where it ends.
function posts(x, y,    n, gap, height, thick)
{
    gap = between(0.7, 2)
    height = between(0.7, 1.4)
    thick = between(0.08, 0.25)
    if (random() < 0.3)
        object("guard_rail", 6 * gap, 0.1, height, x + 3 * gap, y, 0, 0)
    for (n = 0; n < 6; ++n) object("pole", thick, thick, height, x + n * gap, y, 0, 0)
    return x + 6 * gap
}

# Houses at a street's side: tall walls with corners and gaps.
function houses(y,    x, length_m)
{
    for (x = between(-40, -25); x < 100; x += between(1, 14))
    {
        length_m = between(5, 18)
        object("box", length_m, between(5, 9), between(3.5, 9), x + length_m / 2,
               y + between(-2, 2), between(-8, 8), 0)
        x += length_m
    }
}

# What is between two piers of a front: a window, a door in its recess, a passage, steps or a box.
function opening(x, y, side, length_m, height_m,    kind)
{
    kind = oneOf("window window window door door passage steps")
    if (kind == "window")
        object("wall", length_m, 0.3, between(0.4, 1.1), x + length_m / 2, y, 0, 0)
    if (kind == "door" || kind == "steps")
        object("wall", length_m, 0.1, height_m, x + length_m / 2, y + side * between(0.2, 1.3), 0, 0)
    if (kind == "steps")
        object("box", length_m, between(0.4, 1.2), between(0.3, 1.1), x + length_m / 2,
               y - side * between(0.2, 0.6), 0, 0)
}

# Fronts of houses on one side of the street; `side`: 1 left, -1 right.
function fronts(y, side,    x, end, pier, gap, height, at, room)
{
    for (x = between(-35, -25); x < 90; x = end + between(0, 6))
    {
        end = x + between(6, 20)
        at = y + between(-1.5, 1.5)
        height = between(3.2, 9)
        room = between(0.8, 5)
        if (random() < 0.8)  # the room's back, and what divides it
            object("wall", end - x, 0.2, height, (x + end) / 2, at + side * room, 0, 0)
        while (x < end)
        {
            pier = between(0.3, 2.5)
            object("wall", pier, 0.4, height, x + pier / 2, at, 0, 0)
            if (random() < 0.3)
                object("wall", room, 0.2, height, x + pier / 2, at + side * room / 2, 90, 0)
            x += pier
            gap = between(0.8, 2.4)
            opening(x, at, side, gap, height)
            x += gap
        }
    }
}

# Standing objects in a row along the road; `turn`: largest angle to it.
function row(y, vehicles, turn, gap,    x, class, heading, speed)
{
    for (x = between(-30, -20); x < 95; x += between(0.8, gap))
    {
        if (random() < 0.06) x = posts(x, y) + 1
        if (green && random() < 0.4) x = group(x, y) + between(0.8, gap)
        class = random() < vehicles ? vehicle() : clutter()
        heading = (random() < 0.5 ? 0 : 180) + between(-turn, turn)
        if (turn > 60) x += sizeW / 2 + sizeL / 4
        x += sizeL / 2
        speed = class == "pedestrian" && random() < 0.5 ? between(0.5, 1.6) : 0
        object(class, sizeL, sizeW, sizeH, x, y + between(-0.3, 0.3), heading, speed)
        x += sizeL / 2
        if (turn > 60) x += sizeW / 2 + sizeL / 4
    }
}

BEGIN {
    state = 1 + (seed * 7919) % 2147483645
    for (i = 0; i < 5; ++i) random()
    platform = between(2, 12)
    printf "# Made by scripts/random-scene.awk, seed %d.\n\n", seed
    printf "[scenario]\nduration_s = 6\nseed = %d\nstart_time_s = 1700000000\n\n", seed
    printf "[sensor]\nmodel = %s\nx_m = 0.8\nz_m = %.2f\n\n", sensor, between(1.6, 2.3)
    printf "[platform]\nx_m = 0\ny_m = -1.75\nspeed_mps = %.2f\n", platform
    if (random() < 0.5)
        printf "\n[terrain]\nslope_percent = %.1f\nslope_direction_deg = %.0f\n" \
               "bump_amplitude_m = %.2f\nbump_wavelength_m = %.0f\n",
               between(0, 6), between(0, 180), between(0, 0.15), between(15, 40)
    lane(-1.75, 0, platform + between(-1, 2))
    lane(1.75, 180, between(4, 14))
    row(-4.6, 0.6, 4, 5)
    row(4.6, 0.6, 4, 5)
    if (built)
    {
        fronts(-between(8, 12), -1)
        fronts(between(8, 12), 1)
        exit
    }
    row(-8.6, 0.1, 40, 6)
    row(8.6, 0.1, 40, 6)
    row(-15, 0.35, 90, 6)
    row(15, 0.35, 90, 6)
    if (random() < 0.5) houses(-27)
    else row(-26, 0.25, 30, 8)
    if (random() < 0.5) houses(27)
    else row(26, 0.25, 30, 8)
}
