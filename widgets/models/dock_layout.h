// A layout of the window's docks as a value, and as JSON that people can read and edit.
#pragma once

#include <map>
#include <vector>

#include <QJsonObject>
#include <QRect>
#include <QStringList>

#include "core/base/result.h"

namespace usar::widgets {

/// A group of docks that share one place as tabs; or, with `parts`, several places in a row or a column.
struct DockPlace {
    QStringList tabs{};             ///< names of docks, from the left; empty for a split
    QString front{};                ///< the tab that is seen; empty: none is open
    QStringList closed{};           ///< those of `tabs` that are hidden; they open here
    bool side_by_side = false;      ///< of `parts`: from left to right, else from top to bottom
    std::vector<DockPlace> parts{}; ///< two at least, or none
    double share = 0.0;             ///< of the split around it, from 0 to 1; 0 if nothing in it is open

    bool operator==(const DockPlace&) const = default;
    /// True if a dock in it is to be seen.
    bool open() const;
    /// All docks in it, from the top left.
    QStringList docks() const;
};

/// The docks at one edge of the window.
struct DockEdge {
    DockPlace place{};
    double share = 0.0; ///< of the window's width, or height at top and bottom, from 0 to 1; 0 if nothing is open
    bool operator==(const DockEdge&) const = default;
};

/// A dock that is a window of its own.
struct FloatingDock {
    QString dock;
    QRect geometry; ///< in pixels of the desktop, without the frame
    bool open = true;
    bool operator==(const FloatingDock&) const = default;
};

/// What a file in the folder of layouts says.
struct DockLayout {
    QString name;                         ///< as the user calls it
    std::map<QString, DockEdge> edges;    ///< by "left", "right", "top" and "bottom"
    std::vector<FloatingDock> floating{}; ///< in any order; that of a window is sorted by name
    QJsonObject views;                    ///< what the contents of docks add, by the dock's name: {"plots": {…}}
    bool operator==(const DockLayout&) const = default;
};

/// Shares are written to a tenth of a percent.
QByteArray layoutText(const DockLayout& layout);

/// Reads such a text; `file` is named in errors, which say where in the text something is wrong. Refuses a text of a
/// newer version of the program. Keys that are not known are ignored, and missing shares are filled in evenly.
Result<DockLayout> readLayout(const QByteArray& text, const QString& file);

} // namespace usar::widgets
