/* Declares the functions of Modelica's utilities that the package Contactd calls, as in the language specification
 * (12.9.6). Compilers of Modelica provide them, but none is among the packages. */
#ifndef MODELICA_UTILITIES_H
#define MODELICA_UTILITIES_H
void ModelicaError(const char* text);
void ModelicaFormatError(const char* format, ...);
#endif
