// The user's own layouts: one file for each in a folder.
#pragma once

#include "widgets/models/dock_layout.h"

namespace usar::widgets {

/// The layouts as they are on the disk. Reads and writes small files when it is called; errors tell what to do about
/// them. May be used in any one thread.
class LayoutStore {
public:
    /// The folder is made when the first layout is written.
    explicit LayoutStore(QString folder) : folder_(std::move(folder)) {}

    /// Names of all layouts, also of those that cannot be read, sorted as people do.
    QStringList names() const;
    /// The file of a layout: its name, where signs that a file name cannot have are escaped.
    QString fileOf(const QString& name) const;
    /// The layout has the name by which it was asked for, whatever stands in its file.
    Result<DockLayout> read(const QString& name) const;
    /// Replaces the file of the layout's name. Either the whole file is written or none of it.
    Result<void> write(const DockLayout& layout) const;
    /// Fails if there is none of this name.
    Result<void> remove(const QString& name) const;
    /// Reads a file from elsewhere and gives the layout a name that is free: that in the file, with a number if needed.
    Result<DockLayout> import(const QString& path) const;
    /// Writes a layout to a file elsewhere.
    static Result<void> writeTo(const DockLayout& layout, const QString& path);

private:
    QString folder_;
};

} // namespace usar::widgets
