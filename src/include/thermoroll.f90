! Tangled from paper/K-from-other-languages.md; edit there.
! thermoroll for Fortran 2003: compile this file and link with -lthermoroll_c. The meanings, units
! and ranges are told in thermoroll.h, which has the same names.
module thermoroll
  use, intrinsic :: iso_c_binding
  implicit none

  enum, bind(c)
    enumerator :: thermoroll_traction = 0, thermoroll_creep, thermoroll_stick_slip_border
    enumerator :: thermoroll_creep_ratio, thermoroll_tangential_load
    enumerator :: thermoroll_insulated = 0, thermoroll_identical, thermoroll_conducting
    enumerator :: thermoroll_driving = 0, thermoroll_braking
    enumerator :: thermoroll_constant = 0, thermoroll_linear, thermoroll_exponential
    enumerator :: thermoroll_rational, thermoroll_piecewise_linear
    enumerator :: thermoroll_rising = 0, thermoroll_falling
    enumerator :: thermoroll_printed = 0, thermoroll_corrected
    enumerator :: thermoroll_along_contact = 0, thermoroll_as_given
    enumerator :: thermoroll_auto = 0, thermoroll_closed_form, thermoroll_first_order
    enumerator :: thermoroll_coupled, thermoroll_gauss_chebyshev
    enumerator :: thermoroll_no_model = -1, thermoroll_model_closed_form
    enumerator :: thermoroll_model_first_order, thermoroll_model_coupled
    enumerator :: thermoroll_done = 0, thermoroll_failed, thermoroll_refused
    enumerator :: thermoroll_not_converged, thermoroll_rows_failed, thermoroll_no_contact
  end enum

  type, bind(c) :: thermoroll_scene
    integer(c_int32_t) :: size, quantity
    real(c_double) :: given, friction, peclet, heating
    integer(c_int32_t) :: roller, direction
    real(c_double) :: conductivity_ratio, heating_2, peclet_2, bulk_difference
    integer(c_int32_t) :: friction_law, branch
    real(c_double) :: friction_temperature, friction_floor, friction_reference_temperature
    integer(c_int32_t) :: method, formulation
    real(c_double) :: tolerance
    integer(c_int32_t) :: nodes, places
    real(c_double) :: load, speed, half_width, radius, shear_modulus, poisson
    real(c_double) :: expansion, diffusivity, conductivity
    real(c_double) :: expansion_2, conductivity_2, diffusivity_2
    real(c_double) :: bulk_temperature, bulk_temperature_2
  end type

  type, bind(c) :: thermoroll_values
    real(c_double) :: stick_slip_border, slip_length, traction, creep_constant, creep
    real(c_double) :: load_ratio, gamma0, heat_integral, max_temperature, max_temperature_at
    real(c_double) :: eccentricity, heat_1, heat_2, traction_limit, creep_at_traction_limit
  end type
  type, bind(c) :: thermoroll_physical
    real(c_double) :: half_width, radius, creep_ratio, hertz_pressure, max_pressure, max_traction
    real(c_double) :: max_heat_flux, max_temperature_celsius, half_width_over_radius, dissipation
    real(c_double) :: tangential_load, max_temperature_at_m, heat_1, heat_2
    real(c_double) :: contact_temperature_celsius
  end type
  type, bind(c) :: thermoroll_units
    real(c_double) :: length, traction, slip, heat_flux, temperature
  end type
  type, bind(c) :: thermoroll_result
    integer(c_int32_t) :: size, status, model, unknowns
    type(thermoroll_values) :: value, error
    character(kind=c_char) :: message(256)
    type(thermoroll_units) :: unit
    type(thermoroll_physical) :: physical, physical_error
    character(kind=c_char) :: notes(256)
  end type
  type, bind(c) :: thermoroll_point
    integer(c_int32_t) :: size, status
    real(c_double) :: s, pressure, traction, slip, heat_flux, temperature, heat_flux_1, heat_flux_2
    real(c_double) :: depth, temperature_error, friction
    real(c_double) :: pressure_error, traction_error, slip_error, heat_flux_error
  end type
  type, bind(c) :: thermoroll_law_info
    integer(c_int32_t) :: size, status
    real(c_double) :: driving_end, braking_end
    character(kind=c_char) :: message(256)
  end type
  type, bind(c) :: thermoroll_law_value
    integer(c_int32_t) :: size, status
    real(c_double) :: traction, slope, max_temperature, stick_slip_border
    real(c_double) :: traction_error, max_temperature_error, stick_slip_border_error
  end type

  interface
    type(c_ptr) function thermoroll_version() bind(c)
      import
    end function
    type(c_ptr) function thermoroll_message(status) bind(c)
      import
      integer(c_int), value :: status
    end function
    subroutine thermoroll_scene_init(scene, size) bind(c)
      import
      type(thermoroll_scene), intent(out) :: scene
      integer(c_size_t), value :: size
    end subroutine
    integer(c_int) function thermoroll_solve(scenes, results, count, threads) bind(c)
      import
      type(thermoroll_scene), intent(in) :: scenes(*)
      type(thermoroll_result), intent(inout) :: results(*)
      integer(c_size_t), value :: count
      integer(c_int), value :: threads
    end function
    integer(c_int) function thermoroll_profile(scene, result, points, count) bind(c)
      import
      type(thermoroll_scene), intent(in) :: scene
      type(thermoroll_result), intent(inout) :: result
      type(thermoroll_point), intent(inout) :: points(*)
      integer(c_size_t), value :: count
    end function

    type(c_ptr) function thermoroll_law_new(scene, reach, info) bind(c)
      import
      type(thermoroll_scene), intent(in) :: scene
      real(c_double), value :: reach
      type(thermoroll_law_info), intent(inout) :: info
    end function
    integer(c_int) function thermoroll_law_evaluate(law, creeps, values, count) bind(c)
      import
      type(c_ptr), value :: law
      real(c_double), intent(in) :: creeps(*)
      type(thermoroll_law_value), intent(inout) :: values(*)
      integer(c_size_t), value :: count
    end function
    subroutine thermoroll_law_free(law) bind(c)
      import
      type(c_ptr), value :: law
    end subroutine
  end interface
end module thermoroll
