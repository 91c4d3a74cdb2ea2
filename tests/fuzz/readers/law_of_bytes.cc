// SPDX-License-Identifier: LGPL-2.1-or-later
// A law whose description is what the bytes given to describe() say.
#define frictionbeam_law declared_constant // here it changes
#include <frictionbeam/law.h>
#undef frictionbeam_law

#include <cstring>

namespace {

using namespace frictionbeam;

class Law final : public LawBase {
public:
  LawStatus integrate(const LawInput &, LawOutput &) const noexcept override {
    return LawStatus::ok;
  }
};
const Law law;

LawParameter parameters[2];
char texts[8][16];

class Bytes {
public:
  Bytes(const char *begin, const unsigned long size) : next(begin), end(begin + size) {}
  template <typename Type>
  Type take() {
    Type value = Type();
    if (static_cast<unsigned long>(end - next) >= sizeof(Type)) {
      std::memcpy(&value, next, sizeof(Type));
      next += sizeof(Type);
    }
    return value;
  }
  const char *text(const unsigned int number) {
    if (take<signed char>() < 0)
      return nullptr;
    for (unsigned int i = 0; i + 1 < sizeof(texts[number]); ++i)
      texts[number][i] = take<char>();
    return texts[number];
  }

private:
  const char *next, *const end;
};

} // namespace

extern "C" __attribute__((visibility("default"))) LawDescription frictionbeam_law;
LawDescription frictionbeam_law = {};

extern "C" __attribute__((visibility("default"))) void describe(const char *bytes,
                                                                const unsigned long size) {
  Bytes in(bytes, size);
  LawDescription &d = frictionbeam_law;
  d.interface_version = in.take<int>();
  d.kind = static_cast<LawKind>(in.take<int>());
  d.n_strains = in.take<int>();
  d.n_internal_variables = in.take<int>();
  d.symmetric_tangent = in.take<char>() > 0;
  d.n_parameters = in.take<int>();
  if (d.n_parameters > 2) // more than there are, no program can know
    d.n_parameters %= 3;
  d.parameters = in.take<char>() < 0 ? nullptr : parameters;
  d.law = in.take<char>() < 0 ? nullptr : &law;
  d.name = in.text(0);
  d.reference = in.text(1);
  for (unsigned int i = 0; i < 2; ++i)
    parameters[i] = {in.text(2 + 3 * i), in.text(3 + 3 * i), in.take<double>(),
                     in.take<double>(),  in.take<double>(),  in.text(4 + 3 * i)};
}
