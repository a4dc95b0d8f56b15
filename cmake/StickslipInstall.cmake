# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where: the programs, the libraries with their headers, and what
# find_package(stickslip) and pkg-config need. Each module is a target stickslip::<module>.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(modules core lp arrangement engine measures earlier certificate interfaces)
foreach(module IN LISTS modules)
  install(TARGETS stickslip_${module} EXPORT stickslip)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${module}/include/stickslip TYPE INCLUDE)
endforeach()
install(TARGETS stickslip_checker EXPORT stickslip)  # certificate asks it
foreach(dependency IN ITEMS gmp mpfr)
  set_target_properties(stickslip_${dependency} PROPERTIES EXPORT_NAME ${dependency})
  install(TARGETS stickslip_${dependency} EXPORT stickslip)
endforeach()
install(TARGETS stickslip stickslip-check)
if(STICKSLIP_BUILD_PROVED)
  install(PROGRAMS ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/stickslip-proved TYPE BIN)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/certificate/python/check.py ${PROJECT_SOURCE_DIR}/certificate/FORMAT.md
  DESTINATION ${CMAKE_INSTALL_DATADIR}/stickslip)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE TYPE DOC RENAME copyright)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ TYPE DOC FILES_MATCHING PATTERN *.md
  PATTERN doxygen EXCLUDE)

# The manual, if help2man made it, and what completes command lines: of stickslip as it wrote them,
# of stickslip-check by hand.
set(checker ${PROJECT_SOURCE_DIR}/certificate/cpp)
set(completion ${PROJECT_BINARY_DIR}/completion)
install(DIRECTORY ${PROJECT_BINARY_DIR}/man/man1 TYPE MAN OPTIONAL)
install(FILES ${checker}/stickslip-check.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${completion}/stickslip ${checker}/completion/stickslip-check
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
foreach(folder IN ITEMS site-functions vendor-completions)  # zsh's own, and Debian's for packages
  install(FILES ${completion}/_stickslip ${checker}/completion/_stickslip-check
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${folder})
endforeach()
install(FILES ${completion}/stickslip.fish ${checker}/completion/stickslip-check.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/stickslip)
install(EXPORT stickslip NAMESPACE stickslip:: FILE stickslipTargets.cmake
  DESTINATION ${package_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/stickslipConfig.cmake.in
  stickslipConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(stickslipConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/stickslipConfig.cmake
  ${PROJECT_BINARY_DIR}/stickslipConfigVersion.cmake DESTINATION ${package_folder})

# pkg-config finds the prefix from the place of the file, wherever that was unpacked; and the
# libraries in the order of linking: whoever uses one stands before it.
set(pkg_config_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH to_prefix /${pkg_config_folder} /)
set(pkg_config_libraries "")
foreach(module IN ITEMS checker LISTS modules)
  string(PREPEND pkg_config_libraries " -lstickslip_${module}")
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/cmake/stickslip.pc.in stickslip.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/stickslip.pc DESTINATION ${pkg_config_folder})
