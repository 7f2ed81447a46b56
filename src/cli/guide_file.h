// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

#include "core/base/result.h"
#include "core/energy/guidance.h"

namespace fairing::cli {

/// What stands on the command line about guidance; empty paths give nothing. The guide file is that
/// of text/guide_json.h, the reference a shape whose faces guide. Fails with FileUnreadable,
/// GuideInvalid and the codes of readShape() and referenceOn().
[[nodiscard]] Result<energy::Guidance> readGuidance(double lambda,
                                                    double gamma,
                                                    const std::string& guide,
                                                    const std::string& reference);

}  // namespace fairing::cli
