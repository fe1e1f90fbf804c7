// Remembers which plugin ended the program when it was loaded.
#pragma once

#include <QString>

namespace usar::agent {

/// A file as it is at a moment: another one once it has been written anew.
struct FileStamp {
    qint64 bytes = 0;
    qint64 written_ms = 0; ///< since 1970
    bool operator==(const FileStamp&) const = default;
};
FileStamp stampOf(const QString& file);

/// Puts a mark for each plugin into a folder while it is loaded, and takes it away after that went well: what is still
/// there at the next start has ended the program. A plugin that was built anew since is innocent, and so is one that
/// another program is loading at this moment. Without a folder, or where it cannot be written, nothing is remembered.
class PluginMarks {
public:
    PluginMarks() = default;
    explicit PluginMarks(QString folder);

    bool endedTheProgram(const QString& file, const FileStamp& stamp) const;
    void begin(const QString& file, const FileStamp& stamp) const;
    void end(const QString& file) const;

private:
    QString pathOf(const QString& file) const;

    QString folder_;
};

} // namespace usar::agent
