! The cases of cases.py, in a file, through the Fortran module; telling.py says what stands in a line.
!
!     congruence-fortran ipc:///run/contactd.sock cases.txt
program driver
    use contactd
    use answers
    use words
    implicit none
    type(c_ptr) :: place, contact
    integer :: unit
    character(1000) :: line
    integer(c_int32_t) :: nx, ny, states(0:9)

    contact = c_null_ptr
    call open_cases(place, unit)
    do while (next_line(unit, line))
        call take()
    end do
    if (c_associated(contact)) call need(contactd_free(contact))
    call need(contactd_close(place))

contains

    ! --- what a line says

    integer(c_int32_t) function body(i)
        integer, intent(in) :: i
        body = place_of(i, [character(5) :: "upper", "lower", "both", "pair"])
    end function

    ! "base scale step period": base + scale ((step i) mod period), exactly.
    function ramp(i) result(made)
        integer, intent(in) :: i
        real(c_double) :: made(nx * ny)
        integer :: n
        made = [(number(i) + number(i + 1) * mod((n - 1) * whole(i + 2), whole(i + 3)), n=1, nx * ny)]
    end function

    ! A bowl around the middle of the grid, the same in both directions.
    function bowl(scale) result(made)
        real(c_double), intent(in) :: scale
        real(c_double) :: made(nx, ny)
        integer :: x, y
        do y = 1, ny
            do x = 1, nx
                made(x, y) = scale * ((2 * x - nx - 1)**2 + (2 * y - ny - 1)**2)
            end do
        end do
    end function

    ! xx, yy and zz that fall by four with each offset, and nothing else.
    function table(columns, rows, origin) result(made)
        integer(c_int32_t), intent(in) :: columns, rows
        real(c_double), intent(in) :: origin
        real(c_double) :: made(columns, rows, 3, 3)
        integer :: x, y, axis
        made = 0
        do axis = 1, 3
            do y = 1, rows
                do x = 1, columns
                    made(x, y, axis, axis) = scale(origin, -2 * (x + y - 2))
                end do
            end do
        end do
    end function

    ! --- setters

    integer(c_int32_t) function set_up() result(code)
        select case (word(0))
        case ("grid")
            nx = whole(1)
            ny = whole(2)
            code = contactd_set_grid(contact, nx, ny, number(3), number(4), number(5), number(6))
        case ("material"); code = contactd_set_material(contact, body(1), number(2), number(3))
        case ("rigid"); code = contactd_set_rigid(contact, body(1))
        case ("half_space")
            code = contactd_set_half_space(contact, body(1), place_of(2, [character(8) :: "constant", "bilinear"]))
        case ("layers")
            code = layers(place_of(2, [character(8) :: "constant", "bilinear"]))
        case ("fem")
            code = contactd_set_fem(contact, body(1), contactd_half_space, contactd_constant, number(2), 0d0)
        case ("table")
            code = contactd_set_table(contact, body(1), whole(2), whole(3), number(4), number(5), &
                table(whole(2), whole(3), number(6)), 9 * whole(2) * whole(3))
        case ("line_contact"); code = contactd_set_line_contact(contact, number(1))
        case ("model")
            code = contactd_set_model(contact, place_of(1, [character(7) :: "full", "hertz", "fastsim"]))
        case ("tolerance")
            code = contactd_set_tolerance(contact, place_of(1, [character(10) :: "normal", "tangential", "outer"]), &
                number(2), whole(3))
        case ("accept_unconverged"); code = contactd_set_accept_unconverged(contact, 1)
        case ("lease"); code = contactd_set_lease(contact, number(1))
        case ("previous"); code = contactd_set_previous(contact, ramp(1), ramp(5), ramp(9), nx * ny)
        case default; code = set_section()
        end select
    end function

    ! Cross-sections and curved columns.
    integer(c_int32_t) function set_section() result(code)
        real(c_double) :: y(100), z(100), angle(100)
        integer(c_int32_t) :: i, many
        select case (word(0))
        case ("section")
            do i = 3, count - 1
                y(i - 2) = number(i)
            end do
            code = contactd_set_section(contact, body(1), place_of(2, [character(10) :: "outline", "rail_60e1", &
                "rim_s1002", "edge_block", "groove", "round_end", "disc", "plate_hole", "slab"]), y, count - 3)
        case ("section_place"); code = contactd_set_section_place(contact, body(1), number(2), number(3))
        case ("section_accuracy"); code = contactd_set_section_accuracy(contact, body(1), number(2))
        case ("outline"); code = contactd_set_outline(contact, body(1), number(2), number(3))
        case ("line"); code = contactd_add_line(contact, body(1), number(2), number(3), whole(4))
        case ("arc"); code = contactd_add_arc(contact, body(1), number(2), number(3), number(4), whole(5))
        case ("spline") ! "body clamped y z y z ..."
            many = (count - 3) / 2
            do i = 1, many
                y(i) = number(1 + 2 * i)
                z(i) = number(2 + 2 * i)
            end do
            code = contactd_add_spline(contact, body(1), y, z, many, whole(2))
        case ("hole"); code = contactd_add_hole(contact, body(1), number(2), number(3))
        case ("first_column")
            code = contactd_set_first_column(contact, body(1), whole(2), whole(3), number(4))
        case ("profile") ! "body kind curvature smoothing depth from": a parabola
            y(1:69) = [(real(i, c_double), i=-34, 34)]
            z(1:69) = [(i * i * number(3), i=-34, 34)]
            code = contactd_set_profile_points(contact, body(1), place_of(2, [character(5) :: "wheel", "rail"]), &
                y, z, 69, number(4), number(5), number(6))
        case ("columns", "flat_columns") ! "direction origin": of the lower body's section, or of a plane
            y = [(real(i, c_double), i=0, 99)]
            z = 0
            angle = 0
            code = contactd_ok
            if (word(0) == "columns") code = contactd_get_frames(contact, contactd_lower, y, z, angle, ny)
            if (code == contactd_ok) &
                code = contactd_set_columns(contact, y, z, angle, ny, number(1), number(2), number(3))
        case default; code = -1
        end select
    end function

    ! "body shape base_G base_nu", and "thickness G nu" of each layer.
    integer(c_int32_t) function layers(shape) result(code)
        integer(c_int32_t), intent(in) :: shape
        real(c_double) :: thickness(20), G(20), nu(20)
        integer(c_int32_t) :: many, i
        many = (count - 5) / 3
        do i = 1, many
            thickness(i) = number(2 + 3 * i)
            G(i) = number(3 + 3 * i)
            nu(i) = number(4 + 3 * i)
        end do
        code = contactd_set_layers(contact, body(1), shape, thickness, G, nu, many, number(3), number(4))
    end function

    integer(c_int32_t) function load() result(code)
        real(c_double) :: nothing(100) = 0
        select case (word(0))
        case ("approach"); code = contactd_set_approach(contact, number(1))
        case ("Fn"); code = contactd_set_Fn(contact, number(1))
        case ("paraboloid"); code = contactd_set_paraboloid(contact, number(1), number(2))
        case ("semi_axes"); code = contactd_set_semi_axes(contact, number(1), number(2))
        case ("gap"); code = contactd_set_gap(contact, bowl(number(1)), nx * ny)
        case ("gap_of"); code = contactd_set_gap(contact, nothing, whole(1))
        case ("mu"); code = contactd_set_mu(contact, number(1))
        case ("mu_array"); code = contactd_set_mu_array(contact, ramp(1), nx * ny)
        case ("kinetic")
            code = contactd_set_kinetic(contact, place_of(1, [character(11) :: "linear", "exponential"]), &
                number(2), number(3))
        case ("shift"); code = contactd_set_shift(contact, number(1), number(2), number(3))
        case ("duration"); code = contactd_set_duration(contact, number(1))
        case ("rolling")
            code = contactd_set_rolling(contact, place_of(1, [character(9) :: "steady", "transient"]), &
                number(2), number(3), number(4))
        case ("direction"); code = contactd_set_direction(contact, number(1), number(2))
        case ("spin_offset"); code = contactd_set_spin_offset(contact, number(1))
        case ("rolling_steps"); code = contactd_set_rolling_steps(contact, whole(1))
        case ("velocity"); code = contactd_set_velocity(contact, number(1))
        case ("Fx"); code = contactd_set_Fx(contact, number(1))
        case ("Fy"); code = contactd_set_Fy(contact, number(1))
        case ("clear_forces"); code = contactd_clear_forces(contact)
        case ("rigid_slip"); code = contactd_set_rigid_slip(contact, ramp(1), ramp(5), nx * ny)
        case ("derivatives"); code = contactd_want_derivatives(contact, whole(1))
        case default; code = -1
        end select
    end function

    ! The line of a call; one that a setter has refused for is not made.
    subroutine make_call()
        write (*, "(a, 1x, a)", advance="no") trim(name), trim(word(0))
        if (refused == contactd_ok) then
            select case (word(0))
            case ("start"); call note(contact, contactd_start(contact))
            case ("step"); call note(contact, contactd_step(contact))
            case ("again"); call note(contact, contactd_step_again(contact))
            case ("save"); call note(contact, contactd_save(contact, states(whole(1))))
            case ("restore"); call note(contact, contactd_restore(contact, states(whole(1))))
            case ("forget"); call note(contact, contactd_forget(contact, states(whole(1))))
            end select
        end if
        if (refused /= contactd_ok) then
            call tell_refusal()
        else if (word(0) == "step" .or. word(0) == "again") then
            call tell_step(contact, nx, ny)
        end if
        write (*, "()")
        refused = contactd_ok
    end subroutine

    subroutine take()
        integer(c_int32_t) :: code
        integer :: array
        select case (word(0))
        case ("case")
            if (c_associated(contact)) call need(contactd_free(contact))
            call need(contactd_new(place, contact))
            refused = contactd_ok
            name = word(1)
            do array = 1, 6
                call need(contactd_want(contact, arrays(array), 1))
            end do
        case ("start", "step", "again", "save", "restore", "forget")
            call make_call()
        case default
            code = set_up()
            if (code == -1) code = load()
            call note(contact, code)
        end select
    end subroutine
end program driver
