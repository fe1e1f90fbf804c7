// Remembers which plugins ended the program while they were being loaded.
#pragma once

#include <QString>

namespace usar::agent {

/// Identifies one version of a file: it changes whenever the file is rewritten.
struct FileStamp {
    qint64 bytes = 0;
    qint64 written_ms = 0; ///< time of the last change, since 1970
    bool operator==(const FileStamp&) const = default;
};
/// The stamp of the file at this time.
FileStamp stampOf(const QString& file);

/// Keeps a mark file in a folder while a plugin is being loaded, and removes it after success: if a mark is still there
/// at the next start, its plugin has ended the program. Marks are ignored if the plugin has been rebuilt since, or if
/// another running process is loading it. Without a folder, or if it is not writable, nothing is remembered.
class PluginMarks {
public:
    PluginMarks() = default;
    explicit PluginMarks(QString folder);

    /// True if loading this version of the file has ended the program.
    bool endedTheProgram(const QString& file, const FileStamp& stamp) const;
    /// Sets the mark; call it before any code of the plugin runs.
    void begin(const QString& file, const FileStamp& stamp) const;
    /// Removes the mark.
    void end(const QString& file) const;

private:
    QString pathOf(const QString& file) const;

    QString folder_;
};

} // namespace usar::agent
