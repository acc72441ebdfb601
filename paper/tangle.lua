-- The tangler: reads the chapters, writes the C++ that stands in them.
--
--   pandoc --preserve-tabs -f paper/tangle.lua -t plain -o /dev/null paper/*.md
--
-- A chunk is a fenced block with a name, a file, or both; blocks of one name append in order, a
-- block that has a title of its own after a blank line:
--
--   ``` {.cpp #name title="A sentence"}          ``` {.cpp file=src/x.cpp}
--
-- A line `<<name>>` stands for that chunk, each line of it indented as the reference is.
-- A mistake ends the run with `file:line: what is wrong`, and nothing is written.
-- TANGLE_ROOT=DIR   puts the files below DIR instead of the current folder.
-- TANGLE_LINES=1    adds #line directives, so that compilers and debuggers name the chapter.
-- Loaded with dofile(), it only gives the table `tangle`, for the weaver.

tangle = {}

local function fail(where, line, message)
  io.stderr:write(string.format("%s:%d: %s\n", where, line, message))
  os.exit(1)
end

--- The text of a file, or nil.
function tangle.read(path)
  local file = io.open(path, "rb")
  if not file then return nil end
  local text = file:read("a")
  file:close()
  return text
end

-- 1. Parse: a chapter's text to its pieces -------------------------------------------------------

local function attributes(text)
  local found = { classes = {} }
  text = text:gsub('([%w%-]+)="([^"]*)"', function(key, value) found[key] = value; return "" end)
  for word in text:gmatch("%S+") do
    local key, value = word:match("^([%w%-]+)=(.+)$")
    if key then found[key] = value
    elseif word:sub(1, 1) == "#" then found.id = word:sub(2)
    elseif word:sub(1, 1) == "." then table.insert(found.classes, word:sub(2)) end
  end
  return found
end

-- The code of a fence, without the indentation of the fence itself.
local function without_indent(line, indent, source, number)
  if line:match("^%s*$") then return "" end
  if line:sub(1, #indent) ~= indent then
    fail(source, number, "bad indentation: this line is less indented than the fence of its chunk")
  end
  return line:sub(#indent + 1)
end

--- The pieces of one chapter, in order: { id, file, title, lang, source, line, code }.
--- `line` is the number of the first line of code; `id` is the file for a chunk without a name.
function tangle.parse(source, text)
  local pieces, number, fence = {}, 0, nil
  for line in (text:gsub("\n?$", "\n")):gmatch("(.-)\r?\n") do
    number = number + 1
    if not fence then
      local indent, marks, rest = line:match("^(%s*)(```+)([^`]*)$")
      if not marks then indent, marks, rest = line:match("^(%s*)(~~~+)(.*)$") end
      if marks then
        fence = { marks = marks, indent = indent, line = number }
        local inside = rest:match("^%s*{(.*)}%s*$")
        local a = inside and attributes(inside)
        if a and (a.id or a.file) then
          fence.piece = { id = a.id or a.file, file = a.file, title = a.title, lang = a.classes[1],
                          source = source, line = number + 1, code = {} }
          table.insert(pieces, fence.piece)
        end
      end
    else
      local closing = line:match("^%s*([`~]+)%s*$")
      if closing and closing:sub(1, #fence.marks) == fence.marks then
        fence = nil
      elseif fence.piece then
        table.insert(fence.piece.code, without_indent(line, fence.indent, source, number))
      end
    end
  end
  if fence then fail(source, fence.line, "this fence is never closed") end
  return pieces
end

-- 2. Collect: chunks by name, files by path -------------------------------------------------------

local function check_path(piece)
  if piece.file:match("^/") or ("/" .. piece.file .. "/"):find("/../", 1, true) then
    fail(piece.source, piece.line - 1,
         piece.file .. ": a file is named from the project's folder, without ..")
  end
end

--- The pieces of each chunk by its name, the piece that begins each file by its path, and the paths
--- in order.
function tangle.collect(pieces)
  local chunks, files, filed, order = {}, {}, {}, {}
  for _, piece in ipairs(pieces) do
    chunks[piece.id] = chunks[piece.id] or {}
    table.insert(chunks[piece.id], piece)
    if piece.file then
      check_path(piece)
      local first = files[piece.file] or filed[piece.id]
      if first then
        local what = files[piece.file] and piece.file .. " is already filed"
          or string.format("chunk %s is already filed as %s", piece.id, first.file)
        fail(piece.source, piece.line - 1,
             string.format("%s at %s:%d", what, first.source, first.line - 1))
      end
      files[piece.file], filed[piece.id] = piece, piece
      table.insert(order, piece.file)
    end
  end
  return chunks, files, order
end

-- 3. Expand: a file's chunk with every reference replaced ------------------------------------------

local name_pattern = "<<([%w][%w_:/.%-]*)>>"

--- What a reference stands behind, and the name in it; nil for any other line.
function tangle.reference(line) return line:match("^(%s*)" .. name_pattern .. "%s*$") end

local function expand(id, indent, out, state)
  table.insert(state.chain, id)
  state.used[id] = true
  for part, piece in ipairs(state.chunks[id]) do
    state.from[piece.source] = true
    if part > 1 and piece.title then table.insert(out, "") end
    local fresh = true -- the next line needs a #line of its own
    for k, line in ipairs(piece.code) do
      local number = piece.line + k - 1
      local space, name = tangle.reference(line)
      if name then
        if not state.chunks[name] then
          fail(piece.source, number, "missing chunk: <<" .. name .. ">> is nowhere defined")
        end
        for _, above in ipairs(state.chain) do
          if above == name then
            fail(piece.source, number, "cyclic chunks: " .. table.concat(state.chain, " -> ") ..
                                         " -> " .. name)
          end
        end
        expand(name, indent .. space, out, state)
        fresh = true
      elseif line:match("^%s*<<[^<>]*>>%s*$") then
        fail(piece.source, number,
             "bad reference: " .. line:match("<<.*>>") .. " is not the name of a chunk")
      elseif line:match(name_pattern) then
        fail(piece.source, number, "a reference must stand alone on its line: " .. line)
      else
        if fresh and state.lines then
          table.insert(out, string.format('#line %d "%s"', number, piece.source))
        end
        -- With #line the source columns are kept, so that a compiler's caret points true.
        table.insert(out, line == "" and "" or (state.lines and "" or indent) .. line)
        fresh = false
      end
    end
  end
  table.remove(state.chain)
end

--- The lines of a chunk with every reference replaced, and the chapters they come from. With `lines`
--- there are #line directives among them; the names of the chunks that were used are added to `used`.
function tangle.expand(chunks, id, lines, used)
  local out, state = {}, { chunks = chunks, used = used or {}, from = {}, chain = {}, lines = lines }
  expand(id, "", out, state)
  local from = {}
  for source in pairs(state.from) do table.insert(from, source) end
  table.sort(from)
  return out, from
end

-- The mark of a comment, by the end of the file's name; elsewhere //.
local comments = { py = "#", sh = "#", toml = "#", typed = "#", f90 = "!" }

local function header(path, from)
  local chapters = {}
  for _, source in ipairs(from) do table.insert(chapters, "paper/" .. source:match("[^/]*$")) end
  table.sort(chapters)
  return (comments[path:match("%.(%w+)$")] or "//") .. " Tangled from " .. table.concat(chapters, ", ") .. "; edit there."
end

-- 4. Write: only what changed, never half a file ---------------------------------------------------

local function write_if_changed(path, text)
  if tangle.read(path) == text then return end
  local temporary = path .. ".tmp"
  local file = io.open(temporary, "wb")
  if not file then
    os.execute("mkdir -p '" .. path:gsub("/[^/]*$", ""):gsub("'", "'\\''") .. "'")
    file = io.open(temporary, "wb")
  end
  if not (file and file:write(text) and file:close() and os.rename(temporary, path)) then
    fail(path, 0, "cannot be written")
  end
end

--- Pandoc calls this with the chapters named on its command line.
function Reader(sources)
  local pieces = {}
  for _, source in ipairs(sources) do
    for _, piece in ipairs(tangle.parse(source.name, source.text)) do table.insert(pieces, piece) end
  end
  local chunks, files, order = tangle.collect(pieces)
  local lines = (os.getenv("TANGLE_LINES") or "") ~= ""
  local used, texts = {}, {}
  for _, path in ipairs(order) do
    local out, from = tangle.expand(chunks, files[path].id, lines, used)
    texts[path] = header(path, from) .. "\n" .. table.concat(out, "\n") .. "\n"
  end
  for _, piece in ipairs(pieces) do
    if not used[piece.id] then
      fail(piece.source, piece.line - 1, "unused chunk: <<" .. piece.id .. ">> reaches no file")
    end
  end
  local root = os.getenv("TANGLE_ROOT") or "."
  for _, path in ipairs(order) do write_if_changed(root .. "/" .. path, texts[path]) end
  return pandoc.Pandoc({})
end
