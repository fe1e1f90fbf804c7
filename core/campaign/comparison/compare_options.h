// The command line of `usar-mission compare`.
#pragma once

#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/usage/program.h"

namespace usar::campaign {

struct CompareOptions {
    QStringList folders; ///< They hold one campaign each; there are one or two.
    QString baseline;    ///< name of a variant; empty: the first
    QString candidate;   ///< empty: all others, or those of the second folder
    QString html;        ///< files to be written; empty: none
    QString junit;
    QString curve;
    bool json = false; ///< JSON instead of the text
    bool operator==(const CompareOptions&) const = default;
};

/// Reads the command line; `arguments` begins with the verb. Errors name the option and how to write it.
Result<CompareOptions> readCompareOptions(const QStringList& arguments);

/// The verb and its options in words.
usage::Verb compareVerb();

} // namespace usar::campaign
