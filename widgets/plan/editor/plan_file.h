// The file of a plan that is edited: safe reading and writing, watching for changes, and copies of unsaved text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "core/base/result.h"

namespace usar::widgets {

/// Texts are UTF-8 with LF; a file with CR LF or a byte-order mark keeps them when it is saved. GUI thread.
class PlanFile : public QObject {
    Q_OBJECT
public:
    explicit PlanFile(QObject* parent = nullptr);

    /// Replaces any file atomically; it does not become the current one.
    static Result<void> write(const QString& path, const QByteArray& bytes);
    /// Reads a file, which becomes the current one, and returns its text; on error the current file stays.
    Result<std::string> open(const QString& path);
    /// Replaces the file atomically; it becomes the current one. On error the current file stays.
    Result<void> save(const QString& path, std::string_view text);
    /// Starts a plan without a file; `name` is shown to the user. The text counts as saved.
    void startNew(const QString& name, std::string_view text);
    const QString& path() const { return path_; }
    /// File name without its folder, or the name of a new plan.
    QString name() const;
    /// The text as it was last read or written.
    const std::string& savedText() const { return saved_; }

    /// Folder for copies of unsaved texts; empty: no copies are made.
    void setKeepingFolder(const QString& folder) { folder_ = folder; }
    /// Writes a copy of the unsaved text after about a second, once for many calls.
    void keep(std::string_view text);
    /// The copy of this file from a program run that ended without saving; nullopt if there is none or it equals the
    /// saved text.
    std::optional<std::string> kept() const;
    /// Deletes the copy.
    void forgetKept();

signals:
    /// Another program changed the content of the file.
    void changedOnDisk(const std::string& text);

private:
    /// Path of the copy of unsaved text; it depends on the path of the file only.
    QString keptPath() const;
    void writeKept();
    /// Compares the file with the saved text after a change on disk.
    void look();
    /// Makes this file the current one, and watches it and no other. `path` is empty for a new plan, else `new_name`
    /// is.
    void become(const QString& path, const QString& new_name, std::string_view text);

    QString path_;
    QString new_name_;
    std::string saved_;     ///< the text as it was last read or written
    bool has_crlf_ = false; ///< line ends of the file
    bool has_mark_ = false; ///< the file begins with a byte-order mark
    QString folder_;
    std::string to_keep_;
    QTimer keep_timer_;
    QTimer look_timer_;
    QFileSystemWatcher watcher_;
};

} // namespace usar::widgets
