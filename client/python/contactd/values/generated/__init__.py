"""Values whose fields are those of the schemas.

Written by ./dev generate from proto/schema: edit it there.
"""
