#pragma once

#include <string>

namespace rubicon::cli {

/// Tells the user on stderr what is wrong with the input; kWrongInput, to be returned.
int fail(const std::string& message);

}  // namespace rubicon::cli
