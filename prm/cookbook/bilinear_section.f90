! SPDX-License-Identifier: LGPL-2.1-or-later
!
! A section that bends with two rigidities, in Fortran: each moment by itself follows
!   M = EI (kappa - kappa_p),  |M - H kappa_p| <= M_y  (linear kinematic hardening);
! axial force, shear and torsion are elastic. Compile it with
!   gfortran -O2 -shared -fPIC prm/cookbook/bilinear_section.f90 -o bilinear_section.so
! and check it with  frictionbeam-check-law bilinear_section.so 'Yield moment=1e4'
module bilinear_section
  use, intrinsic :: iso_c_binding
  implicit none

  ! What include/frictionbeam/law_c.h declares, field by field.
  type, bind(c) :: parameter_type
    type(c_ptr) :: name, unit
    real(c_double) :: default_value, minimum, maximum
    type(c_ptr) :: meaning
  end type
  type, bind(c) :: input_type
    type(c_ptr) :: parameters, strain, strain_rate, displacement
    real(c_double) :: length, time, time_increment, temperature
    type(c_ptr) :: old_state
    integer(c_int) :: tangent
    real(c_double) :: pressure
  end type
  type, bind(c) :: output_type
    type(c_ptr) :: stress, tangent, new_state
    real(c_double) :: dissipation
    integer(c_int) :: contact
    real(c_double) :: stored_energy, error
  end type
  type, bind(c) :: law_type
    integer(c_int) :: version, size
    type(c_ptr) :: fault, name, reference
    integer(c_int) :: kind, n_states, symmetric_tangent, n_parameters
    type(c_ptr) :: parameters
    type(c_funptr) :: integrate, initialize, threshold
  end type

  integer, parameter :: n = 6, text = 64
  character(kind=c_char, len=text), target :: texts(14)
  type(parameter_type), target :: parameters(4)
  type(law_type), target :: law

contains

  function c_text(i, words)
    integer, intent(in) :: i
    character(len=*), intent(in) :: words
    type(c_ptr) :: c_text
    texts(i) = words//c_null_char
    c_text = c_loc(texts(i))
  end function

  function integrate(in, out) result(status) bind(c)
    type(input_type), intent(in) :: in
    type(output_type), intent(inout) :: out
    integer(c_int) :: status
    real(c_double), pointer :: p(:), strain(:), stress(:), tangent(:, :), old(:), new(:)
    real(c_double) :: rigidity(n), slope, moment, over
    integer :: i
    call c_f_pointer(in%parameters, p, [4])
    call c_f_pointer(in%strain, strain, [n])
    call c_f_pointer(in%old_state, old, [2])
    call c_f_pointer(out%stress, stress, [n])
    call c_f_pointer(out%new_state, new, [2])
    nullify(tangent)
    rigidity = [p(1), p(1)/4, p(1)/4, p(2)/1.3d0, p(2), p(2)]
    stress = rigidity*strain
    if (in%tangent /= 0) then
      call c_f_pointer(out%tangent, tangent, [n, n])
      tangent = 0
      do i = 1, n
        tangent(i, i) = rigidity(i)
      end do
    end if
    do i = 1, 2 ! about y and z: kappa_p is the state
      moment = p(2)*(strain(4 + i) - old(i))
      over = abs(moment - p(4)*old(i)) - p(3)
      new(i) = old(i)
      if (over > 0) then
        new(i) = old(i) + sign(over/(p(2) + p(4)), moment - p(4)*old(i))
        slope = p(2)*p(4)/(p(2) + p(4))
        if (in%tangent == 1 .and. associated(tangent)) tangent(4 + i, 4 + i) = slope
      end if
      stress(4 + i) = p(2)*(strain(4 + i) - new(i))
      ! What hardening stores is not lost: H kappa_p is a spring.
      out%dissipation = out%dissipation + (stress(4 + i) - p(4)*new(i))*(new(i) - old(i))
    end do
    status = 0
  end function

  function frictionbeam_law_c() result(address) bind(c)
    type(c_ptr) :: address
    parameters(1) = parameter_type(c_text(1, 'Axial rigidity'), c_text(2, 'N'), 1d9, 1d0, 1d300, &
                                   c_text(3, 'EA; a quarter of it in shear'))
    parameters(2) = parameter_type(c_text(4, 'Bending rigidity'), c_text(5, 'N m2'), 1d6, 1d0, 1d300, &
                                   c_text(6, 'EI; 1/1.3 of it in torsion'))
    parameters(3) = parameter_type(c_text(7, 'Yield moment'), c_text(8, 'N m'), 1d4, 0d0, 1d300, &
                                   c_text(9, 'M_y, about each axis by itself'))
    parameters(4) = parameter_type(c_text(10, 'Hardening'), c_text(11, 'N m2'), 1d5, 0d0, 1d300, &
                                   c_text(12, 'H'))
    law = law_type(1, int(c_sizeof(law), c_int), c_null_ptr, c_text(13, 'bilinear_section'), &
                   c_text(14, 'FrictionBeam, prm/cookbook/bilinear_section.f90'), 1, 2, 1, 4, &
                   c_loc(parameters), c_funloc(integrate), c_null_funptr, c_null_funptr)
    address = c_loc(law)
  end function
end module
