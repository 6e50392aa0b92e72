/* The functions of Modelica's utilities that the package Contactd calls, as the language specification has them
 * (12.9.6): a compiler of Modelica brings them, and none is among the packages. */
#ifndef MODELICA_UTILITIES_H
#define MODELICA_UTILITIES_H
void ModelicaError(const char* text);
void ModelicaFormatError(const char* format, ...);
#endif
