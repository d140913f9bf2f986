#include "core/exchange/read_bpt.hpp"

#include "core/exchange/imported_mesh.hpp"
#include "core/exchange/text_scanner.hpp"

namespace hariko {

namespace {

class BptReader {
 public:
  explicit BptReader(std::string_view text) : scanner_(text, {.comments = true, .continuation = false}) {}

  Result<std::vector<BicubicNet>> read() {
    if (!scanner_.find_content())
      return TextScanner::error_at_line(e_empty, scanner_.line(), "The file is empty.",
                                        "Export the file again.");
    std::int64_t count = 0;
    if (auto failed = scanner_.read_integer("the number of patches", count)) return *failed;
    if (count < 1 || count > std::int64_t(max_bpt_patches))
      return scanner_.error_here(e_limit, "From 1 to 100000 patches are accepted.", "Split the file.");
    std::vector<BicubicNet> nets;
    for (std::int64_t k = 0; k < count; ++k) {
      nets.emplace_back();
      if (auto failed = read_patch(nets.back())) return *failed;
    }
    return nets;
  }

 private:
  std::optional<Message> read_patch(BicubicNet& net) {
    for (const char* what : {"the first degree", "the second degree"}) {
      if (std::optional<Message> failed = advance(what)) return failed;
      std::int64_t degree = 0;
      if (auto failed = scanner_.read_integer(what, degree)) return failed;
      if (degree != 3)
        return scanner_.error_here(e_format_unknown, "A patch has degree " + std::to_string(degree) + ".",
                                   "Only patches of degree 3 by 3 are read.");
    }
    net.columns = net.rows = 1;
    for (int i = 0; i < 16; ++i) {
      if (std::optional<Message> failed = advance("a control point")) return failed;
      Vector3 point;
      if (auto failed = scanner_.read_point("a control point", point)) return failed;
      net.points.push_back(point);
    }
    return std::nullopt;
  }
  /// To the next token, on this line or a later one.
  std::optional<Message> advance(const char* what) {
    if (!scanner_.find_content()) return scanner_.file_ends(what);
    return std::nullopt;
  }

  TextScanner scanner_;
};

}  // namespace

Result<std::vector<BicubicNet>> read_bpt(std::string_view text) {
  return BptReader(text).read();
}

}  // namespace hariko
