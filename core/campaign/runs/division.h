// Into how many parts the programs divide a campaign that fly it now: all of them must divide it alike.
#pragma once

#include <memory>

#include <QFile>
#include <QString>

#include "core/base/result.h"

namespace usar::campaign {

/// Parts of different divisions overlap: their programs would fly runs twice, and delete each other's files. So the
/// file DIR/division has the number of parts, and the kernel locks it for as long as a program flies one of them.
/// Afterwards the campaign may be divided in another way.
class Division {
public:
    /// Fails while another program divides the campaign into another number of parts, or if the file cannot be written.
    static Result<Division> take(const QString& folder, int parts);

private:
    explicit Division(std::unique_ptr<QFile> file) : file_(std::move(file)) {}
    std::unique_ptr<QFile> file_;
};

} // namespace usar::campaign
