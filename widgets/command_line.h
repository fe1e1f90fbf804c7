// One line of protocol being typed, with waves under what is wrong in it.
#pragma once

#include <QLineEdit>

#include "core/base/diagnostics.h"

namespace usar::widgets {

/// Fixed pitch. Tab is a key like any other while somebody wants it. GUI thread.
class CommandLine : public QLineEdit {
    Q_OBJECT
public:
    explicit CommandLine(QWidget* parent = nullptr);

    /// Offsets in bytes of the text; a wave goes to the end of its word.
    void setDiagnostics(const Diagnostics& diagnostics);
    const Diagnostics& diagnostics() const { return diagnostics_; }
    /// The cursor's place in bytes of the UTF-8 text.
    std::size_t cursorByte() const;
    /// Byte behind the word that begins at `offset`.
    std::size_t wordEnd(std::size_t offset) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Diagnostics diagnostics_;
};

} // namespace usar::widgets
