#include "core/sim/world/sdf_loader.h"

#include <mutex>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include <sdf/Console.hh>

#include "core/base/numbers.h"

namespace usar::sim {

namespace {

constexpr const char* sdf_mend = "Mend the file or generate the world again";

/// While it exists, libsdformat's console writes into `heard()` and not into the log file in the home folder.
class Listener {
public:
    Listener()
        : console_(sdf::Console::Instance())
        , messages_(console_->GetMsgStream().GetStream())
        , log_(console_->GetLogStream().GetStream()) {
        console_->GetMsgStream().SetStream(&text_);
        console_->GetLogStream().SetStream(nullptr);
    }
    ~Listener() {
        console_->GetMsgStream().SetStream(messages_);
        console_->GetLogStream().SetStream(log_);
    }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    std::string heard() const { return text_.str(); }

private:
    sdf::ConsolePtr console_;
    std::ostream* messages_;
    std::ostream* log_;
    std::ostringstream text_;
};

/// Broken XML has no error of its own: the reason and the line appear only on the console.
tl::unexpected<Error> unreadable(const std::string& heard, const std::filesystem::path& file) {
    constexpr std::string_view reason_mark = "XML_ERROR_";
    constexpr std::string_view line_mark = "Line number=";
    const std::size_t reason = heard.find(reason_mark);
    if (reason == std::string::npos)
        return failure("this is not SDFormat", file.string(), sdf_mend);
    const std::string word = heard.substr(reason + reason_mark.size());
    std::string where = file.string();
    const std::size_t line = heard.find(line_mark);
    if (line != std::string::npos) {
        const auto number = readNumberPrefix(std::string_view(heard).substr(line + line_mark.size()));
        where += ":" + fixed(number.value, 0);
    }
    return failure("the XML is broken (" + word.substr(0, word.find(' ')) + ")", where, sdf_mend);
}

} // namespace

Result<sdf::Root> loadSdf(const std::filesystem::path& file) {
    // The library has one console for the whole process, and a canceled world may still be being read by its thread.
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    const Listener listener;
    std::error_code trouble;
    sdf::Root root;
    const sdf::Errors errors = root.Load(std::filesystem::absolute(file, trouble).string());
    if (errors.empty())
        return root;
    const sdf::Error& first = errors.front();
    if (first.Code() == sdf::ErrorCode::FILE_READ)
        return unreadable(listener.heard(), file);
    const auto line = first.LineNumber();
    return failure(first.Message(), line ? file.string() + ":" + std::to_string(*line) : file.string(), sdf_mend);
}

} // namespace usar::sim
