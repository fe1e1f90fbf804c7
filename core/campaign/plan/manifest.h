// The manifest of a campaign: every run by number with its inputs, and what the files were that it depends on.
#pragma once

#include <string>
#include <vector>

#include <QByteArray>
#include <QString>

#include "core/base/result.h"
#include "core/campaign/plan/planned_run.h"

namespace usar::campaign {

/// A file or folder that results depend on. The SHA-256 of a folder is that of its files' names and contents in the
/// order of their names.
struct HashedInput {
    QString role; ///< "mission", "plan", "world", "plugin", "folder", "program"
    QString name; ///< as people know it; it must not depend on where the program is installed
    QByteArray sha256_hex;
    bool operator==(const HashedInput&) const = default;
};

/// Reads the file or the folder. An error names it.
Result<HashedInput> hashInput(const QString& role, const QString& name, const QString& path);

/// Equal manifests give equal results.
struct Manifest {
    std::string campaign; ///< its name
    std::string version;  ///< of the program
    std::vector<HashedInput> inputs;
    std::vector<std::string> missions; ///< names
    std::vector<std::string> variants; ///< names
    std::vector<PlannedRun> runs;
};

/// Returns the text of the manifest's file: one line of JSON with what all runs share, then one line for each run.
QByteArray toText(const Manifest& manifest, const Campaign& campaign);

/// Writes the manifest into the folder, which is created, or checks that the one that is there is the same. The error
/// says in which of the inputs they differ: results of different inputs must not be mixed.
Result<void> keepManifest(const QByteArray& text, const QString& folder);

/// The name of the manifest's file in a campaign's folder.
inline constexpr char manifest_file[] = "manifest.jsonl";

} // namespace usar::campaign
